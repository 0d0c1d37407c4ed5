#pragma once

#include <random>
#include <string>
#include <vector>

#include "mrroc/robot_model.hpp"

/// Postures of a robot drawn at random, for checks at the start and for pictures of its workspace. Configuration time
/// only.
namespace mrroc::edp {

/// Evenly distributed within the joint limits; where a joint has none, from -pi to pi, where it has one, 2 pi from it.
JointVector random_joints(const RobotModel& model, std::mt19937_64& random);

/// Whether the motors bring the robot there within their limits. Joint limits are not checked.
bool within_motor_limits(const RobotModel& model, const JointVector& joints);

/// Home, then random postures within joint and motor limits: `count` of them, or fewer of a robot with hardly any.
/// The same ones for the same seed.
std::vector<JointVector> postures(const RobotModel& model, int count, std::uint64_t seed);

/// "(0, -1.5708, 0.25)", six digits each.
std::string joints_text(const Eigen::Ref<const Eigen::VectorXd>& values);

}  // namespace mrroc::edp
