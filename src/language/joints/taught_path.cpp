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
#include <iterator>
#include <string_view>

#include "core/number_text.hpp"
#include "core/shown_text.hpp"
#include "core/text_lines.hpp"
#include "language/limits.hpp"

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
  throw NonFatalError(ErrorCode::invalid_argument,
                      file + ": cannot be written" + reason + ", expected an existing, writable folder");
}

/// An empty file with a unique name: another run may save the same path at the same time.
std::string new_file_beside(const std::string& file) {
  for (int number = 1;; ++number) {
    std::string name = file + "." + std::to_string(::getpid()) + "-" + std::to_string(number) + ".new";
    const int fd = ::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (fd < 0 && errno == EEXIST) continue;
    if (fd < 0) cannot_write(file);
    ::close(fd);
    return name;
  }
}

/// A file that is read, and the position in it.
struct Reader {
  std::string file;
  int line = 0;

  [[noreturn]] void refuse(const std::string& what, const std::string& expected) const {
    const std::string place = line > 0 ? ":" + std::to_string(line) : std::string{};
    throw NonFatalError(ErrorCode::invalid_argument,
                        core::shown(file + place + ": " + what + ", expected " + expected));
  }
  [[noreturn]] void refuse(const std::string& column, std::string_view value, const std::string& what,
                           const std::string& expected) const {
    refuse(column + ": '" + std::string{value} + "': " + what, expected);
  }
};

double number(const Reader& at, const std::string& column, std::string_view cell) {
  const auto value = core::to_finite(cell);
  if (!value) at.refuse(column, cell, core::number_problem(cell), "a finite number such as -0.25");
  return *value;
}

/// Columns with another separator, from a spreadsheet.
void refuse_separators(const Reader& at, std::string_view line) {
  if (line.find(',') != std::string_view::npos) return;
  for (const auto& [separator, name] : {std::pair{';', "semicolons"}, std::pair{'\t', "tabs"}})
    if (line.find(separator) != std::string_view::npos)
      at.refuse("columns with " + std::string{name} + " between", "commas between the columns, and points in numbers");
}

/// Reads the line of column names.
TaughtPath begin(const Reader& at, const Robot& robot, std::string_view line, std::vector<std::string>& columns) {
  refuse_separators(at, line);
  const std::vector<std::string_view> names = core::cells_of(line, ',');
  columns.assign(names.begin(), names.end());
  std::string known;
  for (const TaughtPath::Space space : {TaughtPath::Space::joints, TaughtPath::Space::poses}) {
    for (const bool timed : {true, false}) {
      const std::vector<std::string> good = columns_of(robot, space, timed);
      if (columns == good) return {space, timed, {}};
      if (timed) known += (known.empty() ? "'" : " or '") + joined(good) + "'";
    }
  }
  at.refuse("columns '" + joined(columns) + "' are not those of a path of robot " + robot.parameters().type,
            known + ", each also without time");
}

JointVector joints_of(const Reader& at, const Robot& robot, const std::vector<std::string_view>& cells,
                      std::size_t first) {
  const auto& axes = robot.parameters().axes;
  JointVector joints(static_cast<Eigen::Index>(axes.size()));
  for (std::size_t i = 0; i < axes.size(); ++i) {
    const std::string_view cell = cells[first + i];
    const double value = number(at, axes[i].name, cell);
    if (!is_within(value, axes[i].position_min, axes[i].position_max))
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

namespace {

std::string content_of(const Reader& at) {
  std::ifstream in(at.file, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(in), {}};
  std::error_code error;
  if (!in.is_open() || in.bad() || std::filesystem::is_directory(at.file, error))
    at.refuse("cannot be read", "a file with a taught path");
  return text;
}

/// The cells of a line, one per column; empty: the line has no point.
std::vector<std::string_view> values_of(const Reader& at, std::string_view line,
                                        const std::vector<std::string>& columns) {
  if (line.find_first_not_of(" \t,;") == std::string_view::npos) return {};
  std::vector<std::string_view> cells = core::cells_of(line, ',');
  const std::size_t found = cells.size();
  if (found < columns.size() && line.ends_with(',')) cells.resize(columns.size());  // the empty ones are reported
  if (cells.size() == columns.size()) return cells;
  const std::string hint = found > columns.size() ? "; numbers have a point, not a comma" : "";
  at.refuse(std::to_string(found) + " values",
            std::to_string(columns.size()) + ", one for each of '" + joined(columns) + "'" + hint);
}

TaughtPoint point_of(const Reader& at, const Robot& robot, const TaughtPath& path,
                     const std::vector<std::string_view>& cells) {
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
  return point;
}

TaughtPath read_path(Reader& at, const Robot& robot, core::TextLines lines) {
  TaughtPath path;
  std::vector<std::string> columns;
  while (lines.next()) {
    at.line = lines.number();
    std::string_view line = core::trimmed(lines.line());
    if (line.starts_with("\"#")) continue;  // a spreadsheet has put the comment in quotes
    line = core::trimmed(core::without_comment(line, '#'));
    if (line.empty()) continue;
    if (columns.empty()) {
      if (line.find_first_not_of(" \t,;") != std::string_view::npos) path = begin(at, robot, line, columns);
      continue;
    }
    const std::vector<std::string_view> cells = values_of(at, line, columns);
    if (!cells.empty()) path.points.push_back(point_of(at, robot, path, cells));
  }
  if (columns.empty())
    at.refuse("no line of column names", "'" + joined(columns_of(robot, TaughtPath::Space::joints, true)) + "'");
  if (path.points.empty()) at.refuse("no point", "at least one line of values");
  return path;
}

/// The largest share of its velocity limit that an axis needs between two points; of the tool at 1 m/s and 1 rad/s when
/// the path is of poses.
double greatest_speed(const Robot& robot, const TaughtPath& path) {
  double greatest = 0;
  for (std::size_t k = 1; k < path.points.size(); ++k) {
    const TaughtPoint &a = path.points[k - 1], &b = path.points[k];
    if (path.space == TaughtPath::Space::poses) {
      const double turn = Eigen::AngleAxisd(a.pose.linear().transpose() * b.pose.linear()).angle();
      const double way = (b.pose.translation() - a.pose.translation()).norm();
      greatest = std::max(greatest, std::max(way, turn) / (b.time - a.time));
    } else {
      for (Eigen::Index i = 0; i < a.joints.size(); ++i) {
        const double limit = robot.parameters().axes[static_cast<std::size_t>(i)].velocity_max;
        greatest = std::max(greatest, std::abs(b.joints[i] - a.joints[i]) / (b.time - a.time) / limit);
      }
    }
  }
  return greatest;
}

/// Times in milliseconds would turn a path of seconds into one of hours.
void check_times(const Reader& at, const Robot& robot, const TaughtPath& path) {
  constexpr double kLong = 600;  // s
  constexpr double kCrawling = 1e-3;
  if (!path.timed || path.points.back().time - path.points.front().time < kLong) return;
  const double speed = greatest_speed(robot, path);
  if (speed == 0 || speed >= kCrawling) return;  // the robot may also have been at rest
  const double hours = (path.points.back().time - path.points.front().time) / 3600;
  at.refuse("time", text_of(path.points.back().time),
            "makes a path of " + text_of(std::round(100 * hours) / 100) + " h, nowhere faster than " +
                text_of(std::round(1e6 * speed) / 1e4) + " % of the velocity limits",
            "seconds, not milliseconds (for a path that is meant to be this slow: faster times, and Replay with a low "
            "speed)");
}

}  // namespace

TaughtPath load_taught_path(const std::string& file, const Robot& robot) {
  Reader at{file};
  const std::string text = content_of(at);
  try {
    TaughtPath path = read_path(at, robot, core::TextLines(text));
    check_times(at, robot, path);
    return path;
  } catch (const core::TextError& error) {
    at.line = error.line;
    at.refuse(error.problem, error.expected);
  }
}

}  // namespace mrroc
