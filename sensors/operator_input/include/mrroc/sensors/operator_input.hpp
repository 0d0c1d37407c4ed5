#pragma once

#include <string>

#include "mrroc/condition.hpp"
#include "mrroc/sensor.hpp"

namespace mrroc {

/// A number from the operator, type `operator_input`; the question and the valid answers are in
/// the deployment. Task's thread.
class OperatorInput : public Sensor {
 public:
  /// Throws NonFatalError when the deployment has no such sensor.
  OperatorInput(Task& task, const std::string& name);

  /// Puts the question to the operator and returns; an earlier answer no longer counts. Throws NonFatalError when the
  /// sensor is not interactive.
  void ask() { bias(); }
  /// Whether the operator has answered since the last `ask()`, as of the last reading.
  bool answered() const noexcept { return value(0) > 0.5; }
  /// The answer; NaN without an answer.
  double answer() const noexcept;
};

/// The operator has answered.
class Answered : public Condition {
 public:
  explicit Answered(const OperatorInput& input) : Condition(input.name() + " answered"), input_(&input) {}

 protected:
  bool holds() override { return input_->answered(); }

 private:
  const OperatorInput* input_;
};

/// Asks the operator, waits, and returns the answer. Robots hold meanwhile. Throws NonFatalError(sensor_not_ready) when
/// the wait is ended from outside before the answer, and the exceptions of `Wait`.
double ask(OperatorInput& input);

}  // namespace mrroc
