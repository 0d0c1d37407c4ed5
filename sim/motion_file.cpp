#include "sim/motion_file.hpp"

#include <cerrno>
#include <cstring>
#include <stdexcept>

#include "config/robot_parameters_file.hpp"
#include "config/table.hpp"

namespace mrroc::sim {

MotionFile::MotionFile(const std::filesystem::path& path, const config::Deployment& deployment,
                       const WorldMemory& memory)
    : deployment_(deployment), memory_(memory), file_(std::fopen(path.c_str(), "we")) {
  if (file_ == nullptr)
    throw std::runtime_error("motion file " + path.string() + ": " + std::strerror(errno) +
                             ", expected a file to write");
  for (const config::RobotEntry& robot : deployment_.robots)
    if (robot.in_world()) write_limits(robot);
}

void MotionFile::write_limits(const config::RobotEntry& robot) {
  const auto file = config::robot_file(robot.type, robot.type + ".toml");
  const RobotParameters parameters = config::read_robot_parameters(config::Table::load(file));
  std::fprintf(file_, "# limits %s", robot.name.c_str());
  for (const AxisParameters& axis : parameters.axes) std::fprintf(file_, " %.9g", axis.position_min);
  for (const AxisParameters& axis : parameters.axes) std::fprintf(file_, " %.9g", axis.position_max);
  for (const AxisParameters& axis : parameters.axes) std::fprintf(file_, " %.9g", axis.velocity_max);
  std::fputc('\n', file_);
}

MotionFile::~MotionFile() {
  const bool failed = std::ferror(file_) != 0;
  if (std::fclose(file_) != 0 || failed)
    std::fprintf(stderr, "motion file: %s, it is not whole\n", std::strerror(errno));
}

void MotionFile::write(Tick tick) {
  for (std::size_t i = 0; i < deployment_.robots.size(); ++i) {
    const config::RobotEntry& robot = deployment_.robots[i];
    JointMeasurement measurement{};
    if (!robot.in_world() || !memory_.measurements[i].load(measurement)) continue;
    JointDrive drive{};
    memory_.drives[i].load(drive);
    std::fprintf(file_, "%llu %s %d", static_cast<unsigned long long>(tick), robot.name.c_str(), drive.enabled == 0);
    for (std::uint32_t j = 0; j < drive.joint_count; ++j) std::fprintf(file_, " %.9g", measurement.position[j]);
    for (std::uint32_t j = 0; j < drive.joint_count; ++j) std::fprintf(file_, " %.9g", measurement.velocity[j]);
    std::fputc('\n', file_);
  }
}

}  // namespace mrroc::sim
