#pragma once

#include <string>

#include "kinematics/chain_model.hpp"

namespace mrroc::cli {

/// Lines for people: positions of single axes at which the arm is singular wherever its other axes are, and the part of
/// random postures that are near any singularity: the smallest singular value of the Jacobian, with lengths in units of
/// the arm's own, is below 0.01. The same arm gives the same text. Any thread.
std::string singularity_lines(const kinematics::ChainModel& model);

}  // namespace mrroc::cli
