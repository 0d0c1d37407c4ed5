#include "kinematics/measured_joints.hpp"

#include <cmath>
#include <string>

#include "mrroc/errors.hpp"

namespace mrroc::kinematics {

namespace {

constexpr int kIterations = 4;  // gears are some mrad: an error of 1 mrad is one of 1e-24 after the third

void check(std::size_t found, int count, const char* what) {
  if (found != 0 && found != static_cast<std::size_t>(count))
    throw SystemError(ErrorCode::configuration,
                      std::to_string(found).append(" measured ").append(what) + ", expected " + std::to_string(count));
}

}  // namespace

MeasuredJoints::MeasuredJoints(const MeasuredArm& measured, int count)
    : zeros_(measured.zeros.size() != 0 ? measured.zeros : JointVector(JointVector::Zero(count))),
      gears_(measured.gears) {
  check(static_cast<std::size_t>(measured.zeros.size()), count, "zeros");
  check(gears_.size(), count, "gears");
}

JointVector MeasuredJoints::joints(const JointVector& encoders) const noexcept {
  JointVector joints = encoders + zeros_;
  for (std::size_t i = 0; i < gears_.size(); ++i) {
    const auto axis = static_cast<Eigen::Index>(i);
    const double e = encoders[axis];
    joints[axis] += gears_[i].dot(Eigen::Vector3d(e, std::cos(e) - 1, std::sin(e)));
  }
  return joints;
}

JointVector MeasuredJoints::slopes(const JointVector& encoders) const noexcept {
  JointVector slopes = JointVector::Ones(encoders.size());
  for (std::size_t i = 0; i < gears_.size(); ++i) {
    const auto axis = static_cast<Eigen::Index>(i);
    slopes[axis] += gears_[i].dot(Eigen::Vector3d(1, -std::sin(encoders[axis]), std::cos(encoders[axis])));
  }
  return slopes;
}

JointVector MeasuredJoints::encoders(const JointVector& joints) const noexcept {
  JointVector encoders = joints - zeros_;
  if (gears_.empty()) return encoders;
  for (int i = 0; i < kIterations; ++i) encoders -= (this->joints(encoders) - joints).cwiseQuotient(slopes(encoders));
  return encoders;
}

}  // namespace mrroc::kinematics
