#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <string>

#include "config/entries/errors_entry.hpp"
#include "config/table.hpp"
#include "mrroc/testing/scratch_folder.hpp"
#include "replace.hpp"
#include "text_of.hpp"

namespace mrroc::test {

/// A copy of a deployment that names a calibration file.
inline std::filesystem::path with_calibration(const task_test::ScratchFolder& folder, const std::string& deployment,
                                              const char* scene, const std::filesystem::path& calibration) {
  std::string text = text_of(deployment);
  replace(text, "[deployment]\n", "[deployment]\ncalibration = ['" + calibration.string() + "']\n");
  replace(text, "\"" + std::string(scene) + "\"",
          "'" + (std::filesystem::path(deployment).parent_path() / scene).string() + "'");
  return folder.write("calibrated.toml", text);
}

inline Eigen::Vector3d vector(const config::Table& table, const char* key) {
  return Eigen::Vector3d(table.numbers(key, 3).data());
}

/// The errors of a simulated world with this set of sizes.
inline config::ErrorsEntry errors_of(const task_test::ScratchFolder& folder, const std::filesystem::path& set,
                                     const std::string& seed) {
  return config::read_errors(
      config::Table::parse(folder / "errors.toml", "set = '" + set.string() + "'\nseed = " + seed));
}

}  // namespace mrroc::test
