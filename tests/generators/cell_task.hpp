#pragma once

#include <functional>
#include <string>

#include "mrroc/robot.hpp"
#include "mrroc/sensor.hpp"
#include "mrroc/task.hpp"

namespace mrroc::test {

/// Common part of the task process of every test cell: a period of 2 ms, no sensor, no operator, no wall clock. A cell
/// adds its robots and its time.
class CellTask : public Task {
 public:
  static constexpr double kPeriod = 0.002;  // s

  const std::string& process_name() const noexcept override { return name_; }
  std::string robot_name(const std::string& name) const override { return name; }
  SensorLink& sensor_link(const std::string& name, const std::string&, bool&) override {
    throw NonFatalError(ErrorCode::invalid_argument, "no sensor " + name);
  }
  double servo_period() const noexcept override { return kPeriod; }
  double wall_seconds() const noexcept override { return 0; }
  OperatorRequest operator_request() noexcept override { return OperatorRequest::none; }
  double operator_speed() const noexcept override { return speed_at ? speed_at(tick()) : 1; }
  bool take_trigger() noexcept override { return false; }
  StepObserver* observer() noexcept override { return nullptr; }

  /// The operator's speed; 1 without it.
  std::function<double(Tick)> speed_at;

 private:
  std::string name_ = "cell";
};

}  // namespace mrroc::test
