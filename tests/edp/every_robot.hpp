#pragma once

#include <filesystem>
#include <functional>
#include <ostream>
#include <string>
#include <vector>

#include "robots/conveyor/conveyor_model.hpp"
#include "robots/irb6/irb6_model.hpp"
#include "robots/irb6_five_axis/irb6_five_axis_model.hpp"
#include "robots/irb6_track/irb6_track_model.hpp"
#include "robots/polycrank/polycrank_model.hpp"
#include "robots/serial_parallel/serial_parallel_model.hpp"
#include "robots/two_finger_gripper/two_finger_gripper_model.hpp"

namespace mrroc {

/// A robot of this project and the reader of its parameter file.
struct KnownRobot {
  std::string type;
  std::function<RobotModels(const std::filesystem::path&)> load;
  std::string stem = type;  ///< of its files

  /// robots/<type>/<stem>.<extension> of the source tree.
  std::filesystem::path file(const std::string& extension) const {
    return std::filesystem::path(MRROC_SOURCE_DIR) / "robots" / type / (stem + "." + extension);
  }
};

/// For GoogleTest's messages.
inline void PrintTo(const KnownRobot& robot, std::ostream* out) { *out << robot.stem; }

inline std::vector<KnownRobot> every_robot() {
  using File = std::filesystem::path;
  const auto irb6 = [](const File& file) { return load_irb6(file); };
  const auto conveyor = [](const File& file) { return load_conveyor(file); };
  return {{"conveyor", conveyor},
          {"conveyor", conveyor, "fast"},
          {"irb6", irb6},
          {"irb60", irb6},
          {"irb6_five_axis", [](const File& file) { return load_irb6_five_axis(file); }},
          {"irb6_track", [](const File& file) { return load_irb6_track(file); }},
          {"polycrank", [](const File& file) { return load_polycrank(file); }},
          {"serial_parallel", [](const File& file) { return load_serial_parallel(file); }},
          {"two_finger_gripper", [](const File& file) { return load_two_finger_gripper(file); }}};
}

}  // namespace mrroc
