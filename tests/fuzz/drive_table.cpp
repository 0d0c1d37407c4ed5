// A table of drives for the IRb-6 and, behind the line "====", an EDS file "own.eds" beside it; then the settings that
// would be written into each drive.
#include "config/drives/drive_table.hpp"

#include <cmath>
#include <set>

#include "config/robot_parameters_file.hpp"
#include "drivers/socketcan/drive_setup.hpp"
#include "fuzz/fuzz.hpp"
#include "mrroc/testing/scratch_folder.hpp"

namespace {

using namespace mrroc;

void check(const config::DriveTable& table, const RobotParameters& robot) {
  fuzz::require(table.drives.size() == robot.axes.size(), "a drive for each axis");
  std::set<unsigned> nodes{table.master};
  for (std::size_t i = 0; i < table.drives.size(); ++i) {
    const config::DriveEntry& drive = table.drives[i];
    fuzz::require(drive.axis == robot.axes[i].name, "drives are in the order of the axes");
    fuzz::require(drive.node >= 1 && drive.node <= canopen::kMaxNode, "a node has a number");
    fuzz::require(nodes.insert(drive.node).second, "every node has its own number");
    fuzz::require(std::isfinite(drive.units_per_turn) && std::abs(drive.units_per_turn) >= 1, "a turn has units");
    for (const config::NodeSetting& setting : drive.settings) {
      const int bits = 8 * setting.size;
      fuzz::require(bits == 64 || (setting.value >= -(1LL << (bits - 1)) && setting.value < 1LL << bits),
                    "a setting fits its object");
    }
    try {
      for (const config::NodeSetting& setting : edp::drive_settings(table, drive, 0.002))
        fuzz::require(setting.size >= 1 && setting.size <= 8, "a setting is a number of whole bytes");
    } catch (const config::ConfigurationError&) {  // a homing speed beyond 32 bits
    }
  }
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const task_test::ScratchFolder folder;
  static const RobotParameters robot =
      config::read_robot_parameters(config::Table::load(MRROC_SOURCE_DIR "/robots/irb6/irb6.toml"));
  static const bool placed = setenv("MRROC_SHARE", MRROC_BINARY_DIR "/share/mrroc", 1) == 0;
  fuzz::require(placed, "the framework's own EDS file is found");
  fuzz::Bytes input(data, size);
  const auto file = folder.write("drives.toml", std::string(input.take_section()));
  folder.write("own.eds", std::string(input.rest()));
  fuzz::refuses<config::ConfigurationError>([&] { check(config::read_drive_table(file, robot), robot); });
  return 0;
}
