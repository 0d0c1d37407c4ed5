#pragma once

#include <string>

#include "config/deployment.hpp"
#include "links/exchange/operator_requester.hpp"
#include "vsp/source.hpp"

namespace mrroc::vsp {

/// The operator as hardware: r is `answers`, the number of answered questions, and `value`, the last
/// answer (0 before the first). At most one question is open; an answer without a question, to an earlier one, or one
/// that the sensor does not accept is ignored.
class OperatorSource final : public Source {
 public:
  /// `prefix`: "<deployment>/<sensor>"; `entry` outlives the source. Waits for the operator's end of the link, for
  /// `timeout` s at most: before the clock starts. Throws as links::connect.
  OperatorSource(const config::SensorEntry& entry, links::Domain& domain, clock::Clock& clock,
                 const std::string& prefix, double timeout);

  /// `silent` when a question could not be sent.
  SourceState read(Tick wanted, RawReading& raw) noexcept override;
  /// Puts the question at `tick`; an open one is cancelled.
  void ask(Tick tick) noexcept;

 private:
  const config::SensorEntry* entry_;
  links::OperatorRequester link_;
  std::uint64_t open_ = 0;  // number of the open question; 0: none
  bool lost_ = false;
  double answers_ = 0;
  double value_ = 0;
};

}  // namespace mrroc::vsp
