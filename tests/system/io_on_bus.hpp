#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "replace.hpp"
#include "system/mrroc_run.hpp"
#include "text_of.hpp"

namespace mrroc::test {

namespace fs = std::filesystem;
inline const fs::path kTasks = fs::path(MRROC_SOURCE_DIR) / "tasks";

/// The deployment of a task, with absolute paths of these files.
inline std::string deployment_of(const std::string& task, const std::vector<std::string>& files) {
  std::string text = text_of(kTasks / task / (task + ".toml"));
  for (const std::string& file : files)
    replace(text, "\"" + file + "\"", "\"" + (kTasks / task / file).string() + "\"");
  return text;
}

/// Puts the next robot of `text`, `robot`, on a bus of its own in `folder`, with the I/O nodes of `io`.
inline void put_on_bus(std::string& text, const ScratchFolder& folder, const std::string& robot, const fs::path& io) {
  replace(text, "hardware = \"mujoco\"", "hardware = \"socketcan\"");
  text += "\n[robots." + robot + ".can]\nsimulated = true\ninterface = \"unix:" + (folder.path() / robot).string() +
          "\"\nio = \"" + io.string() + "\"\n";
}

/// A table of a node with 8 inputs and 8 outputs.
inline fs::path io_of_16(const ScratchFolder& folder) {
  return folder.write("io.toml",
                      "[[nodes]]\nnode = 40\neds = \"cia401.eds\"\ndigital_inputs = 8\ndigital_outputs = 8\n");
}

}  // namespace mrroc::test
