#include "robots/irb6/transmission.hpp"

#include <cmath>
#include <numbers>

#include "robots/irb6/arm_plane.hpp"

namespace mrroc::irb6 {

using std::numbers::pi;

Screw::Screw(const ScrewGeometry& geometry, double zero) noexcept : geometry_(geometry), zero_(zero) {}

double Screw::length(double angle) const noexcept {
  return std::sqrt(geometry_.squares + geometry_.cosine * std::cos(angle) - geometry_.sine * std::sin(angle));
}

bool Screw::reaches(double angle) const noexcept {
  return std::abs(angle) <= pi && geometry_.cosine * std::sin(angle) + geometry_.sine * std::cos(angle) <= 0;
}

double Screw::motor(double angle) const noexcept {
  return geometry_.gear * (length(angle) - geometry_.synchro_length) + zero_;
}

double Screw::ratio(double angle) const noexcept {
  return -geometry_.gear * (geometry_.cosine * std::sin(angle) + geometry_.sine * std::cos(angle)) /
         (2 * length(angle));
}

std::optional<double> Screw::angle(double motor) const noexcept {
  const double screw = (motor - zero_) / geometry_.gear + geometry_.synchro_length;
  const double c = screw * screw - geometry_.squares;  // = cosine cos t - sine sin t
  const double discriminant = geometry_.cosine * geometry_.cosine + geometry_.sine * geometry_.sine - c * c;
  if (!(screw > 0 && discriminant >= 0)) return std::nullopt;  // also when `motor` is NaN
  const double d = std::sqrt(discriminant);
  return std::atan2(-(geometry_.sine * c + geometry_.cosine * d), geometry_.cosine * c - geometry_.sine * d);
}

Transmission::Transmission(const Geometry& geometry) noexcept
    : lower_arm_(geometry.lower_arm_screw, geometry.zero[1]),
      upper_arm_(geometry.upper_arm_screw, geometry.zero[2]),
      column_gear_(geometry.column_gear),
      wrist_pitch_gear_(geometry.wrist_pitch_gear),
      wrist_roll_gear_(geometry.wrist_roll_gear),
      tool_roll_gear_(geometry.tool_roll_gear),
      zero_(geometry.zero) {}

ErrorCode Transmission::motors_to_joints(const JointVector& motors, JointVector& joints) const noexcept {
  const auto t2 = lower_arm_.angle(motors[1]);
  const auto t3 = upper_arm_.angle(motors[2]);
  if (!t2 || !t3 || !motors.allFinite()) return ErrorCode::motor_limit;
  const double pitch_turn = motors[3] - zero_[3];
  const double t4 = pitch_turn / wrist_pitch_gear_;
  joints.resize(zero_.size());
  joints.head<5>() << (motors[0] - zero_[0]) / column_gear_,  //
      *t2,                                                    //
      *t3 - *t2 - pi / 2,                                     //
      t4 - *t3,                                               //
      (motors[4] - zero_[4] - pitch_turn) / wrist_roll_gear_;
  if (has_tool_roll()) joints[5] = (motors[5] - zero_[5]) / tool_roll_gear_;
  return ErrorCode::none;
}

ErrorCode Transmission::joints_to_motors(const JointVector& joints, JointVector& motors) const noexcept {
  const ArmAngles angles(joints);
  if (!lower_arm_.reaches(angles.lower_arm) || !upper_arm_.reaches(angles.upper_arm)) return ErrorCode::joint_limit;
  const double pitch_turn = wrist_pitch_gear_ * angles.wrist;
  JointVector result(zero_.size());
  result.head<5>() << column_gear_ * joints[0] + zero_[0],  //
      lower_arm_.motor(angles.lower_arm),                   //
      upper_arm_.motor(angles.upper_arm),                   //
      pitch_turn + zero_[3],                                //
      wrist_roll_gear_ * joints[4] + zero_[4] + pitch_turn;
  if (has_tool_roll()) result[5] = tool_roll_gear_ * joints[5] + zero_[5];
  if (!result.allFinite()) return ErrorCode::joint_limit;
  motors = result;
  return ErrorCode::none;
}

JointMatrix Transmission::matrix(const JointVector& joints) const noexcept {
  const ArmAngles angles(joints);
  JointMatrix g = JointMatrix::Zero(zero_.size(), zero_.size());
  g(0, 0) = column_gear_;
  g(1, 1) = lower_arm_.ratio(angles.lower_arm);
  g(2, 1) = g(2, 2) = upper_arm_.ratio(angles.upper_arm);
  g(3, 1) = g(3, 2) = g(3, 3) = wrist_pitch_gear_;
  g(4, 1) = g(4, 2) = g(4, 3) = wrist_pitch_gear_;  // the wrist roll turns along with motor 4
  g(4, 4) = wrist_roll_gear_;
  if (has_tool_roll()) g(5, 5) = tool_roll_gear_;
  return g;
}

}  // namespace mrroc::irb6
