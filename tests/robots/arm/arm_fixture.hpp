#pragma once

#include <filesystem>

#include "robots/arm/arm_model.hpp"

namespace mrroc {

inline const std::filesystem::path kBenchArm =
    std::filesystem::path(MRROC_SOURCE_DIR) / "tests/robots/arm/share/robots/bench_arm/bench_arm.toml";

}  // namespace mrroc
