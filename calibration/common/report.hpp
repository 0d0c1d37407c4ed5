#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "mrroc/types.hpp"

namespace mrroc::calibration {

/// A figure of a calibration and the largest value with which it is accepted.
struct Bound {
  std::string what;  ///< "force residual"
  std::string unit;
  double value = 0;
  double largest = 0;
};

/// Prints "accepted: ..." or "refused: ..." with every figure and its bound. Throws NonFatalError that names the
/// figures beyond their bounds, in the same words. Task's thread.
void judge(const std::vector<Bound>& bounds);

/// Writes a calibration file: `text` below comments that say what wrote it and which figures were accepted. Prints its
/// name. Throws SystemError(resources). Task's thread.
void write_calibration(const std::filesystem::path& file, const std::string& kind, const std::string& device,
                       const std::vector<Bound>& bounds, const std::string& text);

/// "[0.1, -2, 3e-05]": numbers of TOML with six significant digits.
std::string toml_list(const Eigen::Ref<const Eigen::VectorXd>& values);

/// A number with `digits` significant digits, in every locale with a point.
std::string shown_number(double value, int digits = 6);

}  // namespace mrroc::calibration
