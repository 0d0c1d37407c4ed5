#pragma once

#include <memory>
#include <string>

#include "edp/check/urdf.hpp"

namespace mrroc::cli {

/// The forward kinematics of a URDF by KDL, joint by joint, without anything that SerialChain computes. One thread.
class KdlArm {
 public:
  /// Throws config::ConfigurationError as arm_of.
  KdlArm(const edp::Urdf& urdf, const std::string& base, const std::string& tip);
  ~KdlArm();
  KdlArm(const KdlArm&) = delete;
  KdlArm& operator=(const KdlArm&) = delete;

  int size() const noexcept;
  /// The tip in the base's frame; `joints`: as many as the arm has.
  Pose flange(const JointVector& joints);

 private:
  struct Solver;
  std::unique_ptr<Solver> solver_;
};

}  // namespace mrroc::cli
