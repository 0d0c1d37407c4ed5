#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "config/drives/drive_table.hpp"
#include "config/message_of.hpp"
#include "mrroc/robot_parameters.hpp"
#include "mrroc/testing/scratch_folder.hpp"

namespace mrroc::config {

inline AxisParameters axis(const std::string& name, double coarse, double fine) {
  AxisParameters parameters;
  parameters.name = name;
  parameters.motor_min = -400;
  parameters.motor_max = 500;
  parameters.encoder_increments = 4000;
  parameters.current_max = 15;
  parameters.synchro_coarse = coarse;
  parameters.synchro_fine = fine;
  return parameters;
}

/// A robot of three axes, the last one without a switch; line 1 of every table names its EDS file.
class DriveTableTest : public testing::Test {
 protected:
  DriveTableTest() {
    robot_.type = "crane";
    robot_.axes = {axis("column", -15, 3.5), axis("arm", 20, -2), axis("belt", 0, 0)};
    std::filesystem::copy_file(MRROC_SOURCE_DIR "/src/canopen/cia402.eds", scratch_.path() / "drive.eds");
  }

  static std::string drive(const std::string& name, int node, const std::string& more = "") {
    return "[[drives]]\naxis = '" + name + "'\nnode = " + std::to_string(node) + "\nrated_current = 10\n" + more;
  }
  /// Lines 3 and following are `general`; the first drive follows, with `first` at its end.
  static std::string table(const std::string& general = "", const std::string& first = "",
                           const std::string& mode = "position") {
    return "eds = 'drive.eds'\nmode = '" + mode + "'\n" + general + drive("column", 1, first) + drive("arm", 2) +
           drive("belt", 3);
  }

  DriveTable read(const std::string& text) const {
    return read_drive_table(scratch_.write("crane_drives.toml", text), robot_);
  }
  std::string message(const std::string& text) const {
    return replace_folder(message_of(scratch_.path(), [&] { read(text); }));
  }
  std::string replace_folder(std::string text) const {
    const std::string folder = scratch_.path().string() + "/";
    if (const auto at = text.find(folder); at != std::string::npos) text.erase(at, folder.size());
    return text;
  }
  /// The drive's EDS file without one section.
  void leave_out(const std::string& section) const {
    std::ifstream stream(MRROC_SOURCE_DIR "/src/canopen/cia402.eds");
    std::string text, line;
    for (bool out = false; std::getline(stream, line);) {
      if (line.starts_with("[")) out = line.starts_with("[" + section + "]");
      if (!out) text += line + "\n";
    }
    scratch_.write("drive.eds", text);
  }

  task_test::ScratchFolder scratch_;
  RobotParameters robot_;
};

}  // namespace mrroc::config
