#pragma once

#include <rapidcheck.h>

#include <algorithm>

#include "generators/planned_cell.hpp"
#include "geometry/rigid_motion.hpp"
#include "language/limits.hpp"
#include "language/random_values.hpp"
#include "mrroc/move.hpp"
#include "mrroc/robots/irb6.hpp"
#include "robots/irb6/irb6_model.hpp"

namespace mrroc::test {

/// Extremes of a motion over its ticks, as parts of the limits.
struct Worst {
  double velocity = 0, acceleration = 0, jerk = 0, position = 0;
  double speed = 0, angular_speed = 0;  ///< of the tool, m/s, rad/s
};

/// An IRb-6 at rest at home, with a random macrostep; its limits are checked in every tick.
struct PathCell : PlannedCell {
  PathCell() : PlannedCell(load_irb6().front()), home(kinematics().direct(axes_home())) {
    arm.set_macrostep(static_cast<std::uint16_t>(fakes::pick(2, 25)), 2);
    on_tick = [this](const DesiredState& now, const DesiredState& before, const RobotCommand& command) {
      check(now, before, command);
    };
  }
  JointVector axes_home() { return desired().position; }
  Pose random_pose() const {
    Pose pose = home;
    pose.translation() += fakes::random_vector(0.12);
    pose.linear() = exp_rotation(fakes::random_vector(0.25)) * home.linear();
    return pose;
  }
  /// The final position of the tool.
  Pose end() const { return kinematics().direct(desired().position); }
  /// False: refused before any motion, because the robot cannot reach a pose.
  bool move(Generator& generator) {
    try {
      RC_ASSERT(Move({arm}, {}, generator).ending == Ending::generator);
      return true;
    } catch (const NonFatalError& error) {
      RC_LOG() << error.what() << "\n";
      RC_ASSERT(ticks == 0);
      return false;
    }
  }
  void assert_limits() const {
    RC_ASSERT(worst.velocity <= 1);
    RC_ASSERT(worst.acceleration <= 1);
    RC_ASSERT(worst.jerk <= 1);
    RC_ASSERT(worst.position <= 1);
  }

  Irb6 arm{*this};
  Pose home;
  Worst worst;
  int ticks = 0;

 private:
  void check(const DesiredState& now, const DesiredState& before, const RobotCommand& command) {
    ++ticks;
    for (Eigen::Index i = 0; i < now.position.size(); ++i) {
      const AxisParameters& axis = axes()[static_cast<std::size_t>(i)];
      const auto raise = [](double& value, double seen) { value = std::max(value, seen); };
      raise(worst.velocity, std::abs(now.velocity[i]) / axis.velocity_max);
      raise(worst.velocity, std::abs(now.position[i] - before.position[i]) / kPeriod / axis.velocity_max - 1e-9);
      raise(worst.acceleration, std::abs(now.acceleration[i]) / axis.acceleration_max);
      raise(worst.jerk, std::abs(now.acceleration[i] - before.acceleration[i]) / kPeriod / axis.jerk_max);
      raise(worst.position, std::max(now.position[i] - axis.position_max, axis.position_min - now.position[i]) /
                                position_tolerance(axis.position_min, axis.position_max));
    }
    if (command.kind != CommandKind::pose) return;
    const Pose a = kinematics().direct(before.position), b = kinematics().direct(now.position);
    worst.speed = std::max(worst.speed, (b.translation() - a.translation()).norm() / kPeriod);
    worst.angular_speed =
        std::max(worst.angular_speed, rotation_vector(b.linear() * a.linear().transpose()).norm() / kPeriod);
  }
};

}  // namespace mrroc::test
