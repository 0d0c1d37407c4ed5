#pragma once

#include <string>

#include "links/transport/reader.hpp"
#include "links/transport/writer.hpp"
#include "links/wire/operator_messages.hpp"

namespace mrroc::links {

/// The asking end of an operator link, in a VSP or a task process: topics `<prefix>/question` and `<prefix>/answer`. It
/// never waits for the operator. The participant's thread.
class OperatorRequester {
 public:
  /// `prefix`: "<deployment>/<sensor or process>".
  OperatorRequester(Domain& domain, clock::Clock& clock, const std::string& prefix);

  /// Hand-shake with the operator's end, about `timeout` s at most; before the clock starts. Throws as links::connect.
  void connect(double timeout);

  /// Sends a question and returns its number (1, 2, ...). Throws SystemError when DDS refuses it.
  std::uint64_t ask(const OperatorQuestion& question);
  /// The oldest answer not yet taken. Neither waits, locks nor allocates.
  bool take(OperatorAnswer& answer);

 private:
  Writer<OperatorQuestion> writer_;
  Reader<OperatorAnswer> reader_;
  std::uint64_t asked_ = 0;
};

}  // namespace mrroc::links
