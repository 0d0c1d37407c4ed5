// Robot parameter files: the first byte selects the robot, the rest is its file. An accepted file passes through the
// checks that an EDP makes before it opens the drives.
#include <array>

#include "config/robot_parameters_file.hpp"
#include "edp/check/model_check.hpp"
#include "fuzz/fuzz.hpp"
#include "fuzz/memory_file.hpp"
#include "robots/conveyor/conveyor_model.hpp"
#include "robots/irb6/irb6_model.hpp"
#include "robots/irb6_five_axis/irb6_five_axis_model.hpp"
#include "robots/irb6_track/irb6_track_model.hpp"
#include "robots/polycrank/polycrank_model.hpp"
#include "robots/serial_parallel/serial_parallel_model.hpp"
#include "robots/two_finger_gripper/two_finger_gripper_model.hpp"

namespace {

using Load = mrroc::RobotModels (*)(const std::filesystem::path&);
constexpr std::array<Load, 7> kRobots{&mrroc::load_conveyor,          &mrroc::load_irb6,
                                      &mrroc::load_irb6_five_axis,    &mrroc::load_irb6_track,
                                      &mrroc::load_polycrank,         &mrroc::load_serial_parallel,
                                      &mrroc::load_two_finger_gripper};

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const fuzz::MemoryFile memory;
  fuzz::Bytes input(data, size);
  const Load load = kRobots[input.take<std::uint8_t>() % kRobots.size()];
  const auto file = memory.write(input.rest());
  fuzz::refuses<mrroc::config::ConfigurationError>([&] {
    const mrroc::RobotModels models = load(file);
    fuzz::require(!models.empty(), "a robot has a model");
    mrroc::edp::check_models(models, mrroc::config::Table::load(file));
    const auto& parameters = models.front()->parameters();
    fuzz::require(models.front()->flange(parameters.home).matrix().allFinite(), "the home pose is finite");
  });
  return 0;
}
