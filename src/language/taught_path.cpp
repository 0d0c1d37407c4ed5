#include "mrroc/taught_path.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string_view>

namespace mrroc {

namespace {

constexpr std::array<const char*, 7> kPoseColumns{"x", "y", "z", "qw", "qx", "qy", "qz"};
constexpr double kQuaternionError = 1e-3;

std::vector<std::string> columns_of(const Robot& robot, TaughtPath::Space space, bool timed) {
  std::vector<std::string> columns;
  if (timed) columns.emplace_back("time");
  if (space == TaughtPath::Space::poses)
    columns.insert(columns.end(), kPoseColumns.begin(), kPoseColumns.end());
  else
    for (const AxisParameters& axis : robot.parameters().axes) columns.push_back(axis.name);
  return columns;
}

std::string joined(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ",") + name;
  return text;
}

/// The shortest text that reads back to the same bits.
std::string text_of(double value) {
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
  return {text.data(), end};
}

[[noreturn]] void cannot_write(const std::string& file) {
  const std::string reason = errno != 0 ? std::string{": "} + std::strerror(errno) : "";
  throw NonFatalError(ErrorCode::invalid_argument, file + ": cannot be written" + reason +
                                                       ", expected a folder that is there and may be written to");
}

/// An empty file with a name of its own: another run may save the same path at the same time.
std::string new_file_beside(const std::string& file) {
  for (int number = 1;; ++number) {
    const std::string name = file + "." + std::to_string(::getpid()) + "-" + std::to_string(number) + ".new";
    const int fd = ::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (fd < 0 && errno == EEXIST) continue;
    if (fd < 0) cannot_write(file);
    ::close(fd);
    return name;
  }
}

/// A file that is read, and the place in it.
struct Reader {
  std::string file;
  int line = 0;

  [[noreturn]] void refuse(const std::string& what, const std::string& expected) const {
    const std::string place = line > 0 ? ":" + std::to_string(line) : std::string{};
    throw NonFatalError(ErrorCode::invalid_argument, file + place + ": " + what + ", expected " + expected);
  }
  [[noreturn]] void refuse(const std::string& column, std::string_view value, const std::string& what,
                           const std::string& expected) const {
    refuse(column + ": '" + std::string{value} + "': " + what, expected);
  }
};

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view kBlanks = " \t\r";
  const std::size_t first = text.find_first_not_of(kBlanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kBlanks) - first + 1);
}

std::vector<std::string_view> cells_of(std::string_view line) {
  std::vector<std::string_view> cells;
  for (;;) {
    const std::size_t comma = line.find(',');
    cells.push_back(trimmed(line.substr(0, comma)));
    if (comma == std::string_view::npos) return cells;
    line.remove_prefix(comma + 1);
  }
}

double number(const Reader& at, const std::string& column, std::string_view cell) {
  double value = 0;
  const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
  if (error != std::errc{} || end != cell.data() + cell.size() || !std::isfinite(value))
    at.refuse(column, cell, "is no number", "a finite number such as -0.25");
  return value;
}

/// Takes the line of column names.
TaughtPath begin(const Reader& at, const Robot& robot, std::string_view line, std::vector<std::string>& columns) {
  const std::vector<std::string_view> names = cells_of(line);
  columns.assign(names.begin(), names.end());
  std::string known;
  for (const TaughtPath::Space space : {TaughtPath::Space::joints, TaughtPath::Space::poses}) {
    for (const bool timed : {true, false}) {
      const std::vector<std::string> good = columns_of(robot, space, timed);
      if (columns == good) return {space, timed, {}};
      if (timed) known += (known.empty() ? "'" : " or '") + joined(good) + "'";
    }
  }
  at.refuse("columns '" + joined(columns) + "' of no path of a robot " + robot.parameters().type,
            known + ", each also without time");
}

JointVector joints_of(const Reader& at, const Robot& robot, const std::vector<std::string_view>& cells,
                      std::size_t first) {
  const auto& axes = robot.parameters().axes;
  JointVector joints(static_cast<Eigen::Index>(axes.size()));
  for (std::size_t i = 0; i < axes.size(); ++i) {
    const std::string_view cell = cells[first + i];
    const double value = number(at, axes[i].name, cell);
    if (value < axes[i].position_min || value > axes[i].position_max)
      at.refuse(axes[i].name, cell, "is beyond the robot's limits",
                text_of(axes[i].position_min) + " to " + text_of(axes[i].position_max));
    joints[static_cast<Eigen::Index>(i)] = value;
  }
  return joints;
}

Pose pose_of(const Reader& at, const std::vector<std::string_view>& cells, std::size_t first) {
  std::array<double, 7> v{};
  for (std::size_t i = 0; i < v.size(); ++i) v[i] = number(at, kPoseColumns[i], cells[first + i]);
  const Eigen::Quaterniond turn(v[3], v[4], v[5], v[6]);
  if (!(std::abs(turn.norm() - 1) < kQuaternionError))
    at.refuse("qw,qx,qy,qz: a quaternion of length " + text_of(turn.norm()), "length 1");
  Pose pose = Pose::Identity();
  pose.translation() << v[0], v[1], v[2];
  pose.linear() = turn.normalized().toRotationMatrix();
  return pose;
}

}  // namespace

void TaughtPath::add(const Robot& robot, double time) {
  const RobotState& state = robot.known_state();
  points.push_back({time, state.desired_joints, state.desired_pose});
}

void save(const TaughtPath& path, const Robot& robot, const std::string& file) {
  if (path.points.empty()) throw NonFatalError(ErrorCode::invalid_argument, file + ": a taught path without a point");
  std::string text = "# mrroc taught path of " + robot.parameters().type + "\n";
  text += joined(columns_of(robot, path.space, path.timed)) + "\n";
  for (const TaughtPoint& point : path.points) {
    std::vector<std::string> cells;
    if (path.timed) cells.push_back(text_of(point.time));
    if (path.space == TaughtPath::Space::joints) {
      for (const double value : point.joints) cells.push_back(text_of(value));
    } else {
      const Eigen::Quaterniond turn(point.pose.linear());
      for (const double value : Eigen::Vector3d{point.pose.translation()}) cells.push_back(text_of(value));
      for (const double value : {turn.w(), turn.x(), turn.y(), turn.z()}) cells.push_back(text_of(value));
    }
    text += joined(cells) + "\n";
  }
  const std::string unfinished = new_file_beside(file);
  errno = 0;
  std::ofstream out(unfinished, std::ios::binary);
  out << text;
  out.close();
  std::error_code error;
  if (out) std::filesystem::rename(unfinished, file, error);
  if (out && !error) return;
  const int reason = error ? error.value() : errno;
  std::filesystem::remove(unfinished, error);
  errno = reason;
  cannot_write(file);
}

TaughtPath load_taught_path(const std::string& file, const Robot& robot) {
  Reader at{file};
  std::ifstream in(file, std::ios::binary);
  if (!in) at.refuse("cannot be read", "a file with a taught path");
  TaughtPath path;
  std::vector<std::string> columns;
  for (std::string text; std::getline(in, text);) {
    ++at.line;
    const std::string_view line = trimmed(text);
    if (line.empty() || line.front() == '#') continue;
    if (columns.empty()) {
      path = begin(at, robot, line, columns);
      continue;
    }
    const std::vector<std::string_view> cells = cells_of(line);
    if (cells.size() != columns.size()) {
      at.refuse(std::to_string(cells.size()) + " values",
                std::to_string(columns.size()) + ", one for each of '" + joined(columns) + "'");
    }
    TaughtPoint point;
    const std::size_t first = path.timed ? 1 : 0;
    if (path.timed) {
      point.time = number(at, "time", cells[0]);
      if (path.points.empty() ? point.time < 0 : point.time <= path.points.back().time) {
        at.refuse("time", cells[0], "does not come after the point before",
                  path.points.empty() ? "at least 0" : "more than " + text_of(path.points.back().time));
      }
    }
    if (path.space == TaughtPath::Space::joints)
      point.joints = joints_of(at, robot, cells, first);
    else
      point.pose = pose_of(at, cells, first);
    path.points.push_back(point);
  }
  if (in.bad()) at.refuse("cannot be read", "a file with a taught path");
  if (columns.empty())
    at.refuse("no line of column names", "'" + joined(columns_of(robot, TaughtPath::Space::joints, true)) + "'");
  if (path.points.empty()) at.refuse("no point", "at least one line of values");
  return path;
}

}  // namespace mrroc
