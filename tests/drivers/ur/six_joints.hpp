#pragma once

#include "edp/test_robots.hpp"

namespace mrroc::ur {

/// Six joints with a gear of 100, driven by a controller of their own.
class SixJoints : public edp::GearedModel {
 public:
  explicit SixJoints(DriveParameters::Interface interface) {
    parameters_.type = "six_joints";
    parameters_.drives = {interface, 10, 5};
    parameters_.axes.assign(6, edp::test_axis("joint"));
    parameters_.home = JointVector::Zero(6);
  }
  Pose flange(const JointVector&) const noexcept override { return Pose::Identity(); }
  ErrorCode inverse(const Pose&, const JointVector&, JointVector&) const noexcept override {
    return ErrorCode::out_of_workspace;
  }
  Jacobian jacobian(const JointVector&, const Eigen::Vector3d&) const noexcept override { return Jacobian::Zero(6, 6); }
};

}  // namespace mrroc::ur
