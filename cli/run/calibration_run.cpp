#include "cli/run/calibration_run.hpp"

#include <fcntl.h>
#include <stdlib.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <fstream>
#include <stdexcept>

#include "config/resources.hpp"
#include "config/table.hpp"
#include "config/text/calibration_text.hpp"
#include "config/text/message_text.hpp"
#include "config/text/toml_text.hpp"

namespace mrroc::cli {

namespace {

using config::ConfigurationError;

constexpr std::size_t kLongestPath = 255;  // of the behaviours' field `into`

/// The device that the option names, or the only one.
std::string chosen(const std::filesystem::path& file, const std::string& option, const std::string& given,
                   const std::vector<std::string>& names, const std::string& what) {
  const auto refuse = [&](const std::string& problem) {
    throw ConfigurationError(file, 0, option, problem, config::alternatives(names));
  };
  if (names.empty()) throw ConfigurationError(file, 0, option, "the deployment has no " + what, "one");
  if (given.empty() && names.size() > 1) refuse("the deployment has " + std::to_string(names.size()) + " of " + what);
  if (!given.empty() && std::find(names.begin(), names.end(), given) == names.end())
    refuse("no " + what + " " + config::in_quotes(given));
  return given.empty() ? names.front() : given;
}

std::vector<std::string> suitable_sensors(const config::Deployment& deployment, const CalibrationKind& kind,
                                          const std::string& robot) {
  std::vector<std::string> names;
  for (const config::SensorEntry& sensor : deployment.sensors)
    if (sensor.type == kind.sensor_type && sensor.robot == (kind.on_robot ? robot : "")) names.push_back(sensor.name);
  return names;
}

/// Robots that can calibrate such a sensor.
std::vector<std::string> suitable_robots(const config::Deployment& deployment, const CalibrationKind& kind) {
  std::vector<std::string> names;
  for (const config::RobotEntry& robot : deployment.robots)
    if ((robot.mount.empty() || !kind.fixed_base) && !suitable_sensors(deployment, kind, robot.name).empty())
      names.push_back(robot.name);
  return names;
}

/// By its first line.
bool is_calibration(const std::filesystem::path& file) {
  if (!std::filesystem::is_regular_file(file)) return false;
  std::string first;
  std::getline(std::ifstream(file), first);
  return first.starts_with("# Written by `mrroc calibrate");
}

/// Why the file cannot be opened for writing, which changes nothing; 0: it can.
int write_error(const std::filesystem::path& file) {
  const bool there = std::filesystem::exists(file);
  constexpr mode_t kMode = 0666;
  const int fd = ::open(file.c_str(), O_WRONLY | O_CLOEXEC | (there ? 0 : O_CREAT | O_EXCL), kMode);
  if (fd < 0) return errno;
  ::close(fd);
  if (!there) ::unlink(file.c_str());
  return 0;
}

std::filesystem::path checked_target(const config::Deployment& deployment, const std::filesystem::path& into) {
  const auto refuse = [&](const std::string& problem, const std::string& expected) {
    throw ConfigurationError(deployment.file, 0, "--into", problem, expected);
  };
  std::filesystem::path target = std::filesystem::absolute(into).lexically_normal();
  if (!std::filesystem::is_directory(target.parent_path()))
    refuse("no folder " + config::in_quotes(target.parent_path().string()), "a file in an existing folder");
  if (std::filesystem::is_directory(target)) refuse(config::in_quotes(into.string()) + " is a folder", "a file");
  if (std::filesystem::exists(target) && !is_calibration(target))
    refuse(config::in_quotes(into.string()) + " exists and is no calibration file",
           "a new file, or one that `mrroc calibrate` has written");
  if (const int error = write_error(target); error != 0)
    refuse(config::in_quotes(into.string()) + " cannot be written: " + std::strerror(error), "a file that can");
  if (target.string().size() > kLongestPath)
    refuse("its absolute path has " + std::to_string(target.string().size()) + " characters",
           "at most " + std::to_string(kLongestPath));
  return target;
}

/// Of the kinds that look at a marker from many sides.
std::vector<CalibrationSetting> view_settings() {
  return {{"marker", true, -1, -1, 100000, "Number of the marker in the camera's dictionary; -1: as deployed"},
          {"marker_size", false, 0, 0, 10, "m: side of its black square, beside --marker; 0: as deployed"},
          {"views", true, 40, 6, 200, "Postures from which the camera looks at it"},
          {"reach", false, 0.12, 0.02, 1, "rad or m by which the last three joints move for the first estimate"},
          {"speed", false, 0.5, 0.01, 1, "Of the robot between them, as a part of its greatest"},
          {"joint_deviation", false, 0, 0, 0.1,
           "rad or m: expected error of each joint's zero; 0: 0.0003, of an arm as measured 0.00003"},
          {"arm_deviation", false, 0, 0, 0.1,
           "m: expected error of the flange from posture to posture; 0: 0.0001, of an arm as measured 0.00001"},
          {"residual_bound", false, 0.002, 1e-5, 0.1, "rad: largest residual of a view that is accepted"}};
}

/// Of `base`: a message has room for 16 fields.
std::vector<CalibrationSetting> with_marker_pose(std::vector<CalibrationSetting> settings) {
  std::erase_if(settings, [](const CalibrationSetting& setting) { return setting.name == "reach"; });
  for (const char* name : {"x", "y", "z"})
    settings.push_back({name, false, 0, -1000, 1000, "m: of the marker's middle in the world", true});
  for (const char* name : {"roll", "pitch", "yaw"})
    settings.push_back({name, false, 0, -2 * M_PI, 2 * M_PI,
                        "rad: of its axes, about the fixed axes x, y, z; its z points out of it, its y up"});
  settings.push_back(
      {"distance_bound", false, 0.1, 0, 1000, "m: largest distance from the deployment's base that is accepted"});
  return settings;
}

/// Of `kinematics`: more views, and the arm's own deviations.
std::vector<CalibrationSetting> of_an_arm(std::vector<CalibrationSetting> settings) {
  for (CalibrationSetting& setting : settings) {
    if (setting.name == "views") setting.value = 90;
    if (setting.name == "joint_deviation")
      setting = {"joint_deviation", false, 0.001, 1e-6, 0.1, "rad or m: expected error of each joint's zero"};
    if (setting.name == "arm_deviation")
      setting = {"arm_deviation", false, 2e-6, 1e-6, 0.1, "m: expected error of the flange that no number explains"};
  }
  settings.push_back({"link_deviation", false, 0.0003, 0, 0.05,
                      "m, and as many rad: expected error of each link; 0: as in the robot's model"});
  settings.push_back({"gear_deviation", false, 0.0002, 0, 0.01,
                      "rad: expected error of each gear's ratio and eccentricity; 0: as in the robot's model"});
  return settings;
}

std::map<std::string, std::string> sees_markers() { return {{"frame", "camera"}, {"detect", "marker"}}; }

}  // namespace

std::vector<CalibrationKind> calibration_kinds() {
  return {{"load",
           "CalibrateLoad",
           "force_torque",
           "Mass and centre of the load behind a wrist's force sensor, and the sensor's zero",
           {},
           {{"postures", true, 12, 6, 100, "Orientations in which the sensor is read"},
            {"reach", false, 0.6, 0.05, 3, "rad or m by which each of the last three joints moves to both sides"},
            {"speed", false, 0.5, 0.01, 1, "Of the robot between them, as a part of its greatest"},
            {"force_bound", false, 0.5, 0.001, 1000, "N: largest residual of an orientation that is accepted"},
            {"torque_bound", false, 0.05, 0.0001, 1000, "N m: largest residual that is accepted"}}},
          {"hand-eye", "CalibrateHandEye", "camera",
           "Pose of a camera on the flange, and its focal length, from views of a marker that does not move",
           sees_markers(), view_settings()},
          {"base", "CalibrateBase", "camera",
           "Pose of a robot's base in the world, from views of a marker whose place there is known", sees_markers(),
           with_marker_pose(view_settings()), true, true},
          {"kinematics", "CalibrateKinematics", "camera",
           "Zeros of a robot's joints, its gears and places of its axes, from views of a marker that does not move",
           sees_markers(), of_an_arm(view_settings())},
          {"camera", "CalibrateCamera", "camera",
           "Pose of a camera that does not move, and its focal length, from views of a marker that a robot carries",
           sees_markers(), view_settings(), false, true}};
}

CalibrationRun::CalibrationRun(CalibrationKind kind, const config::Deployment& deployment, CalibrationOrder order)
    : kind_(std::move(kind)), order_(std::move(order)) {
  const std::string sensor = "sensor of type " + config::in_quotes(kind_.sensor_type);
  order_.robot = chosen(deployment.file, "--robot", order_.robot, suitable_robots(deployment, kind_),
                        kind_.on_robot ? "robot with a " + sensor : "robot beside a " + sensor + " that does not move");
  order_.sensor =
      chosen(deployment.file, "--sensor", order_.sensor, suitable_sensors(deployment, kind_, order_.robot),
             sensor + (kind_.on_robot ? " on robot " + config::in_quotes(order_.robot) : " that does not move"));
  order_.into = checked_target(deployment, order_.into);
  std::string pattern = std::filesystem::temp_directory_path() / "mrroc_calibrate_XXXXXX";
  if (::mkdtemp(pattern.data()) == nullptr)
    throw std::runtime_error("cannot make the folder " + pattern + ": " + std::strerror(errno));
  folder_ = pattern;
  std::ofstream(folder_ / "states.toml") << states();
}

CalibrationRun::~CalibrationRun() {
  std::error_code ignored;
  std::filesystem::remove_all(folder_, ignored);
}

std::string CalibrationRun::deployment_text(const std::string& text) const {
  std::string program = "calibrate_" + kind_.name;
  std::replace(program.begin(), program.end(), '-', '_');
  return config::for_calibration(text,
                                 {order_.robot, program, folder_ / "states.toml", order_.sensor, kind_.sensor_keys});
}

/// One state: the robot calibrates.
std::string CalibrationRun::states() const {
  toml::table start{{"robot", order_.robot},
                    {"behaviour", kind_.behaviour},
                    {"sensor", order_.sensor},
                    {"into", order_.into.string()}};
  for (const CalibrationSetting& setting : kind_.settings) {
    if (setting.whole)
      start.insert(setting.name, std::lround(setting.value));
    else
      start.insert(setting.name, setting.value);
  }
  const toml::table state{{"start", toml::array{std::move(start)}}, {"next", "end"}};
  return config::toml_text(toml::table{{"first", "calibrate"}, {"states", toml::table{{"calibrate", state}}}});
}

}  // namespace mrroc::cli
