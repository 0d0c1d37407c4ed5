#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "cli/robot/import/add_robot.hpp"
#include "config/table.hpp"
#include "mrroc/testing/scratch_folder.hpp"

namespace mrroc::cli {

namespace fs = std::filesystem;

inline const fs::path kSpoilt = MRROC_SOURCE_DIR "/tests/cli/robot/spoilt";

inline std::vector<std::string> names_in(const fs::path& folder) {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder)) names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  return names;
}

/// Imports into a folder of the test.
class AddRobot : public testing::Test {
 protected:
  AddRequest request(const fs::path& urdf) const {
    AddRequest request;
    request.urdf = urdf;
    request.into = folder_ / "robots";
    return request;
  }
  /// The report; the message of the error.
  static std::string result_of(const AddRequest& request) {
    try {
      return add_robot(request);
    } catch (const config::ConfigurationError& error) {
      return error.what();
    }
  }
  task_test::ScratchFolder folder_;
};

}  // namespace mrroc::cli
