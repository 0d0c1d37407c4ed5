#pragma once

#include <string>

#include "cli/robot/type/branch_check.hpp"
#include "cli/robot/type/type_files.hpp"

namespace mrroc::cli {

/// The worst difference between an arm's kinematics and that of others at random postures, and what its inverse finds.
struct TypeCheck {
  static constexpr double kAllowed = 1e-9;  ///< m and rad
  int postures = 0;
  double kdl = 0, mujoco = 0;     ///< m and rad, the larger
  double typical = 0, worst = 0;  ///< processor time of an inverse: median, largest, us
  int found = 0;                  ///< postures that the inverse finds from their poses and a posture nearby
  BranchCheck branches;
  bool agrees() const noexcept { return kdl <= kAllowed && mujoco <= kAllowed; }
  bool passed() const noexcept { return agrees() && branches.passed(); }
};

/// Compares the chain in the parameter file with KDL on the URDF and MuJoCo on the MJCF at `postures` random postures
/// within the limits; computes as many inverses from nearby, and twice as many from home. Throws
/// config::ConfigurationError: a file that cannot be used, a URDF with another number of axes.
TypeCheck check_type(const ChainType& type, int postures);

/// Lines for people.
std::string check_report(const TypeCheck& check);

}  // namespace mrroc::cli
