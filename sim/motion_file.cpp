#include "sim/motion_file.hpp"

#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <utility>

#include "command/output_stream.hpp"
#include "config/robot_parameters_file.hpp"
#include "config/table.hpp"

namespace mrroc::sim {

namespace {

std::string problem(const std::filesystem::path& path, int reason) {
  return "cannot write the motion file " + path.string() + ": " + std::strerror(reason);
}

}  // namespace

MotionFile::MotionFile(int fd, std::filesystem::path path, const config::Deployment& deployment,
                       const world::WorldMemory& memory)
    : deployment_(deployment), memory_(memory), path_(std::move(path)), file_(command::output_stream(fd)) {
  if (file_ == nullptr) throw std::runtime_error(problem(path_, errno));
  for (const config::RobotEntry& robot : deployment_.robots)
    if (robot.in_world()) write_limits(robot);
}

MotionFile::~MotionFile() {
  if (file_ != nullptr) close();
}

std::string MotionFile::close() {
  if (failure_ == 0 && std::fflush(file_) != 0) failure_ = errno;
  if (std::fclose(std::exchange(file_, nullptr)) != 0 && failure_ == 0) failure_ = errno;
  return failure_ == 0 ? "" : problem(path_, failure_);
}

void MotionFile::write_limits(const config::RobotEntry& robot) {
  const RobotParameters parameters = config::read_robot_parameters(config::Table::load(robot.files().parameters));
  std::fprintf(file_, "# limits %s", robot.name.c_str());
  for (const AxisParameters& axis : parameters.axes) std::fprintf(file_, " %.9g", axis.position_min);
  for (const AxisParameters& axis : parameters.axes) std::fprintf(file_, " %.9g", axis.position_max);
  for (const AxisParameters& axis : parameters.axes) std::fprintf(file_, " %.9g", axis.velocity_max);
  std::fputc('\n', file_);
}

void MotionFile::write(Tick tick) {
  if (failure_ != 0) return;
  for (std::size_t i = 0; i < deployment_.robots.size(); ++i) {
    const config::RobotEntry& robot = deployment_.robots[i];
    world::JointMeasurement measurement{};
    if (!robot.in_world() || !memory_.measurements[i].load(measurement)) continue;
    world::JointDrive drive{};
    memory_.drives[i].load(drive);
    std::fprintf(file_, "%llu %s %d", static_cast<unsigned long long>(tick), robot.name.c_str(), drive.enabled == 0);
    for (std::uint32_t j = 0; j < drive.joint_count; ++j) std::fprintf(file_, " %.9g", measurement.position[j]);
    for (std::uint32_t j = 0; j < drive.joint_count; ++j) std::fprintf(file_, " %.9g", measurement.velocity[j]);
    if (std::fputc('\n', file_) == EOF || std::ferror(file_) != 0) failure_ = errno;
  }
}

}  // namespace mrroc::sim
