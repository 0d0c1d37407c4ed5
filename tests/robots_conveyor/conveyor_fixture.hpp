#pragma once

#include <filesystem>

#include "robots/conveyor/conveyor_model.hpp"

namespace mrroc {

inline std::filesystem::path conveyor_source(const std::string& name) {
  return std::filesystem::path(MRROC_SOURCE_DIR) / "robots/conveyor" / name;
}

inline std::shared_ptr<const RobotModel> conveyor_model() {
  static const RobotModels models = load_conveyor(conveyor_source("conveyor.toml"));
  return models.front();
}

inline const AxisParameters& belt() { return conveyor_model()->parameters().axes.front(); }

inline JointVector one(double value) { return JointVector::Constant(1, value); }

}  // namespace mrroc
