#pragma once

#include <gtest/gtest.h>
#include <stdlib.h>

#include <filesystem>
#include <string>

#include "config/deployment.hpp"
#include "config/message_of.hpp"
#include "mrroc/testing/scratch_folder.hpp"

namespace mrroc::config {

inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
  for (auto at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size())) {
    text.replace(at, from.size(), to);
  }
  return text;
}

/// Deployments of the types in tests/config/share, with a folder of programs made for the test. File names are relative
/// to `folder`, the current one.
class DeploymentFixture : public testing::Test {
 protected:
  explicit DeploymentFixture(const std::string& folder) {
    for (const auto* name : {"mrroc_mp", "mrroc_ecp", "mrroc_sim", "press_mp", "press_ecp", "irb6_edp", "conveyor_edp",
                             "irb6_drives", "force_torque_vsp", "operator_input_vsp", "ultrasonic_vsp"}) {
      std::filesystem::permissions(programs_.write(name, ""), std::filesystem::perms::owner_all);
    }
    programs_.write("plain_file", "");
    setenv("MRROC_SHARE", MRROC_SOURCE_DIR "/tests/config/share", 1);
    setenv("MRROC_PROGRAMS", programs_.path().c_str(), 1);
    std::filesystem::current_path(MRROC_SOURCE_DIR "/tests/config/" + folder);
  }
  ~DeploymentFixture() override {
    std::filesystem::current_path("/");
    unsetenv("MRROC_SHARE");
    unsetenv("MRROC_PROGRAMS");
  }

  std::string program(const std::string& name) const { return (programs_.path() / name).string(); }

  /// The error in the file, with SOURCE and PROGRAMS for the folders of this machine; "" if there is none.
  std::string message(const std::filesystem::path& file) const {
    std::string text = message_of(programs_.path(), [&] { load_deployment(file); });
    return replaced(replaced(text, programs_.path().string(), "PROGRAMS"), MRROC_SOURCE_DIR, "SOURCE");
  }

  task_test::ScratchFolder programs_;
};

}  // namespace mrroc::config
