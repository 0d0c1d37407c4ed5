#pragma once

#include <filesystem>
#include <string>

#include "robots/conveyor/conveyor_model.hpp"

namespace mrroc {

/// Stem of the files in robots/conveyor/ that a test executable tests, `conveyor` or `fast`; defined once in each.
std::string conveyor_under_test();

/// robots/conveyor/`name` of the source tree.
inline std::filesystem::path conveyor_source(const std::string& name) {
  return std::filesystem::path(MRROC_SOURCE_DIR) / "robots" / "conveyor" / name;
}

/// robots/conveyor/<stem>.<extension> of the source tree.
inline std::filesystem::path conveyor_file(const std::string& extension) {
  return conveyor_source(conveyor_under_test() + "." + extension);
}

inline std::shared_ptr<const RobotModel> conveyor_model() {
  static const RobotModels models = load_conveyor(conveyor_file("toml"));
  return models.front();
}

inline const AxisParameters& belt() { return conveyor_model()->parameters().axes.front(); }

inline JointVector one(double value) { return JointVector::Constant(1, value); }

}  // namespace mrroc
