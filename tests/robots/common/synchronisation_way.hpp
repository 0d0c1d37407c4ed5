#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "mrroc/robot_model.hpp"

namespace mrroc {

/// Path of the shafts during a synchronisation from `start` (joints), as in the EDP with the switches of simulated
/// drives: axis by axis from its position to half a turn beyond its synchronisation position, on by the stopping
/// distance from coarse speed (v 0.24 s / 2), and back. In steps of at most `step` rad.
inline std::vector<JointVector> synchronisation_way(const RobotModel& model, const JointVector& start, double step) {
  constexpr double kStopTime = 0.24;  // s: edp/safety/shaft_model.hpp, v / a + a / j
  const RobotParameters& robot = model.parameters();
  JointVector shafts;
  if (model.joints_to_motors(start, shafts) != ErrorCode::none) return {};
  std::vector<JointVector> way{shafts};
  const auto go = [&](Eigen::Index axis, double target) {
    const double from = shafts[axis];
    const int count = std::max(1, static_cast<int>(std::ceil(std::abs(target - from) / step)));
    for (int i = 1; i <= count; ++i) {
      shafts[axis] = from + (target - from) * i / count;
      way.push_back(shafts);
    }
  };
  for (std::size_t i = 0; i < robot.axes.size(); ++i) {
    const auto axis = static_cast<Eigen::Index>(robot.synchro_order.empty() ? i : robot.synchro_order[i]);
    const AxisParameters& data = robot.axes[static_cast<std::size_t>(axis)];
    const double ahead = std::copysign(1.0, data.synchro_coarse);
    const double edge = data.motor_synchro + ahead * std::numbers::pi;
    const double stop = ahead * std::abs(data.synchro_coarse) * kStopTime / 2;
    if (ahead * (shafts[axis] - edge) >= 0) go(axis, edge - stop);
    go(axis, edge + stop);
    go(axis, data.motor_synchro + data.synchro_fine * kStopTime / 2);
  }
  return way;
}

}  // namespace mrroc
