#pragma once

#include <string>
#include <vector>

#include "mrroc/robot.hpp"

namespace mrroc {

/// One taught point: the robot's desired state there.
struct TaughtPoint {
  double time = 0;               ///< s since the teaching began
  JointVector joints;            ///< rad or m
  Pose pose = Pose::Identity();  ///< of the tool frame in the robot's base frame
};

/// A taught path: a motion in time (`timed`), or points that the robot visits one after the other.
struct TaughtPath {
  enum class Space : std::uint8_t {
    joints,  ///< the joints are saved and replayed
    poses    ///< the tool's poses are, for use with another tool or robot
  };

  Space space = Space::joints;
  bool timed = false;
  std::vector<TaughtPoint> points;

  /// Adds the robot's desired state. Throws NonFatalError(invalid_argument) when its state is unknown. Task's thread.
  void add(const Robot& robot, double time = 0);
};

/// Writes a path as a table: a line of column names, then a line for each point, values separated by commas. Columns:
/// `time` (s) of a timed path, then the names of the robot's axes (rad, m), or x, y, z (m), qw, qx, qy, qz
/// (orientation, a quaternion of length 1). Lines that begin with # are comments. Every number reads back to the same
/// bits. An old file is replaced only when the new one is complete. Throws NonFatalError(invalid_argument) when the
/// path is empty or the file cannot be written.
///
///     # mrroc taught path of irb6
///     time,column,lower_arm,upper_arm,wrist_pitch,wrist_roll,tool_roll
///     0,0.1,-1.7,0.5,-0.3,4.7,1.57
void save(const TaughtPath& path, const Robot& robot, const std::string& file);

/// Reads such a file, or one that was written by hand or with a spreadsheet: values in double quotes, empty cells at
/// the end of a line and comments behind a blank are accepted; core/text_lines.hpp defines what may surround a line,
/// core/number_text.hpp the numbers. Throws NonFatalError(invalid_argument), one line "file:line: column: value: what
/// is wrong, expected what", when the file is not valid for this robot: other columns, a value that is not a finite
/// number, joints beyond the limits, an invalid quaternion, times that do not increase, no point, or times in
/// milliseconds. The last is assumed for a path of more than ten minutes that is not at rest, but on which no axis ever
/// needs a thousandth of its velocity limit (of poses: 1 mm/s or 1 mrad/s).
TaughtPath load_taught_path(const std::string& file, const Robot& robot);

}  // namespace mrroc
