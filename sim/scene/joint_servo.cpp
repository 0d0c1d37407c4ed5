#include "sim/scene/joint_servo.hpp"

#include <algorithm>
#include <cmath>

namespace mrroc::sim {

JointServo::JointServo(const mjModel& model)
    : acceleration_(static_cast<std::size_t>(model.nv), 0), inertial_(static_cast<std::size_t>(model.nv), 0) {}

void JointServo::compute(const mjModel& model, mjData& data, const world::JointDrive& drive, const Joint* joints,
                         std::size_t count, double elapsed, double h, std::array<double, kMaxJoints>& torque) noexcept {
  const double p = std::exp(-drive.bandwidth * h);
  const bool follows_position = drive.kind == world::JointDrive::Kind::position;
  const double kp = follows_position ? (1 - p) * (1 - p) / (h * h) : 0;
  const double kd = follows_position ? (1 - p * p) / h : (1 - p) / h;
  for (std::size_t i = 0; i < count; ++i) {
    const double error = drive.position[i] + drive.velocity[i] * elapsed - data.qpos[joints[i].position];
    acceleration_[static_cast<std::size_t>(joints[i].dof)] =
        kp * error + kd * (drive.velocity[i] - data.qvel[joints[i].dof]);
  }
  mj_mulM(&model, &data, inertial_.data(), acceleration_.data());
  for (std::size_t i = 0; i < count; ++i) {
    const auto dof = static_cast<std::size_t>(joints[i].dof);
    torque[i] = std::clamp(inertial_[dof] + data.qfrc_bias[dof], -drive.torque_max[i], drive.torque_max[i]);
  }
}

}  // namespace mrroc::sim
