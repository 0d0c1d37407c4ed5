#pragma once

#include <string>

#include "mrroc/condition.hpp"
#include "mrroc/sensor.hpp"

namespace mrroc {

/// A number that the operator is asked for, type `operator_input`; the question and the answers that are taken are in
/// the deployment. Task's thread.
class OperatorInput : public Sensor {
 public:
  /// Throws NonFatalError when the deployment has no such sensor.
  OperatorInput(Task& task, const std::string& name);

  /// Puts the question to the operator and returns; an earlier answer counts no more. Throws NonFatalError when the
  /// sensor is not interactive.
  void ask() { bias(); }
  /// Whether the operator has answered since the last `ask()`, as of the last reading.
  bool answered() const noexcept { return value(0) > 0.5; }
  /// The answer; NaN while there is none.
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
/// the wait is ended from outside before he has answered, and what `Wait` throws.
double ask(OperatorInput& input);

}  // namespace mrroc
