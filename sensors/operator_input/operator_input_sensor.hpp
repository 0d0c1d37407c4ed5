#pragma once

#include "vsp/virtual_sensor.hpp"

namespace mrroc::vsp {

class OperatorSource;

/// The operator's answers. r is `answers`, a count, and `value`, the last answer; v is
///
///     answered = 1 when answers > zero, else 0
///     value    = the last answer when answered, else 0
///
/// `bias` asks: it makes the present count zero, so that an earlier answer no longer counts, and puts the question to
/// the operator. Nothing is asked before the first `bias`. Played readings also count as the operator's answers.
class OperatorInputSensor final : public VirtualSensor {
 public:
  void configure(const config::SensorEntry& entry, double servo_period) override;
  std::unique_ptr<Source> open_source(const SourceContext& context) override;
  void aggregate(const RawReading& r, SensorReading& v) noexcept override;
  bool bias(const RawReading& r) noexcept override;

 private:
  OperatorSource* operator_ = nullptr;  // null: played
  double zero_ = 0;
};

}  // namespace mrroc::vsp
