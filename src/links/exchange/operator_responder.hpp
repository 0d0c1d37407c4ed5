#pragma once

#include <string>

#include "links/transport/reader.hpp"
#include "links/transport/writer.hpp"
#include "links/wire/operator_messages.hpp"

namespace mrroc::links {

/// The operator's end of an operator link, in the runner; it answers the VSP's hand-shake automatically. `take` and
/// `answer` may be called by two threads, each by one at a time.
class OperatorResponder {
 public:
  /// `prefix`: "<deployment>/<sensor or process>".
  OperatorResponder(Domain& domain, clock::Clock& clock, const std::string& prefix);

  /// The oldest question not yet taken, and its number. Neither waits, locks nor allocates.
  bool take(OperatorQuestion& question, std::uint64_t& number);
  /// Sends an answer; does not wait. Throws SystemError when DDS refuses it.
  void answer(const OperatorAnswer& answer);

 private:
  Writer<OperatorAnswer> writer_;
  Reader<OperatorQuestion> reader_;
  std::uint64_t answered_ = 0;
};

}  // namespace mrroc::links
