#pragma once

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <stdexcept>
#include <string>

#include "config/table.hpp"
#include "mrroc/testing/scratch_folder.hpp"
#include "robots/irb6/family/robot_under_test.hpp"
#include "text_of.hpp"

namespace mrroc {

using Loader = std::function<RobotModels(const std::filesystem::path&)>;

/// Loads the robot's parameter file with the first `from` in it replaced by `to`.
inline RobotModels load_with(const Loader& load, const std::string& from, const std::string& to) {
  std::string changed = test::text_of(robot_file("toml"));
  const auto at = changed.find(from);
  if (at == std::string::npos) throw std::runtime_error("no \"" + from + "\" in the file");
  changed.replace(at, from.size(), to);
  const task_test::ScratchFolder folder;
  return load(folder.write(robot_under_test().name + ".toml", changed));
}

/// The error message of this change; empty when there is none.
inline std::string error_with(const Loader& load, const std::string& from, const std::string& to) {
  try {
    load_with(load, from, to);
  } catch (const config::ConfigurationError& error) {
    return error.what();
  }
  return "";
}

}  // namespace mrroc
