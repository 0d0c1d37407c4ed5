#pragma once

#include "kinematics/chain_model.hpp"

namespace mrroc::cli {

/// What the inverse finds at the poses of random postures within the limits, from home.
struct BranchCheck {
  static constexpr double kSame = 1e-5;            ///< rad or m, between two postures that are one
  static constexpr double kReached = 1e-8;         ///< m and rad, of a flange that is at a pose
  static constexpr double kLeastBranches = 0.998;  ///< of the postures
  int postures = 0;
  int reached = 0;                ///< poses for which a motion in joint space gets a posture within the limits
  int branches = 0;               ///< postures that are among the branches of their pose; redundant arms: as `reached`
  int outside = 0;                ///< postures given to a motion that are outside the limits or off the pose
  double typical = 0, worst = 0;  ///< processor time of an inverse from home: median, largest, us
  bool passed() const noexcept { return outside == 0 && branches >= kLeastBranches * postures; }
};

/// `postures` random postures of an arm, always the same ones. Any thread.
BranchCheck check_branches(const kinematics::ChainModel& model, int postures);

}  // namespace mrroc::cli
