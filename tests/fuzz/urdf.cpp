// A robot's URDF: the first byte selects the robot, the rest is the file that is compared with its model.
#include <array>

#include "config/table.hpp"
#include "edp/check/urdf_check.hpp"
#include "fuzz/fuzz.hpp"
#include "fuzz/memory_file.hpp"
#include "robots/conveyor/conveyor_model.hpp"
#include "robots/irb6/irb6_model.hpp"
#include "robots/serial_parallel/serial_parallel_model.hpp"
#include "robots/two_finger_gripper/two_finger_gripper_model.hpp"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const fuzz::MemoryFile file;
  static const std::string robots = MRROC_SOURCE_DIR "/robots/";
  static const std::array<mrroc::RobotModels, 4> kRobots{
      mrroc::load_conveyor(robots + "conveyor/conveyor.toml"), mrroc::load_irb6(robots + "irb6/irb6.toml"),
      mrroc::load_serial_parallel(robots + "serial_parallel/serial_parallel.toml"),
      mrroc::load_two_finger_gripper(robots + "two_finger_gripper/two_finger_gripper.toml")};
  fuzz::Bytes input(data, size);
  const auto& models = kRobots[input.take<std::uint8_t>() % kRobots.size()];
  fuzz::refuses<mrroc::config::ConfigurationError>(
      [&] { mrroc::edp::check_urdf(*models.front(), file.write(input.rest())); });
  return 0;
}
