#include "cli/robot/import/robot_toml.hpp"

#include <cmath>

#include "cli/robot/import/toml_text.hpp"
#include "geometry/rigid_motion.hpp"

namespace mrroc::cli {

namespace {

std::string toml_text(const std::string& text) {
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') quoted += '\\';
    quoted += c;
  }
  return quoted + "\"";
}

std::string toml_key(const std::string& name) { return name.find('.') == std::string::npos ? name : toml_text(name); }

/// x, y, z, roll, pitch, yaw.
std::string toml_pose(const Pose& pose) {
  Eigen::Matrix<double, 6, 1> numbers;
  numbers << pose.translation(), rpy_of(pose.linear());
  return toml_array(numbers);
}

std::string line_of(const std::string& key, const SourcedNumber& number) {
  return key + " = " + toml_number(number.value) + "  # " + number.source + "\n";
}

std::string axis_text(const AxisLimits& axis) {
  std::string text = "\n[[axes]]\nname = " + toml_text(axis.name) + "\n";
  text += line_of("position_min", axis.position_min) + line_of("position_max", axis.position_max);
  text += line_of("velocity_max", axis.velocity) + line_of("acceleration_max", axis.acceleration);
  text += line_of("jerk_max", axis.jerk);
  return axis.torque ? text + line_of("torque_max", *axis.torque) : text;
}

}  // namespace

std::string robot_toml(const std::string& type, const std::string& urdf, const UrdfArm& arm,
                       const std::vector<AxisLimits>& axes, DriveKind kind, const std::vector<AxisDrive>& drives,
                       const JointVector& home) {
  std::string text = "# Made by mrroc robot add from " + urdf + ". Lengths in m, angles in rad, times in s.\n";
  text += "type = " + toml_text(type) + "\nedp = \"mrroc_arm_edp\"\n";
  text += "home = " + toml_array(home) + "  # guessed: far from singularities, without collisions\n";
  text += drives_text(kind);
  for (std::size_t i = 0; i < axes.size(); ++i) text += axis_text(axes[i]) + drive_text(kind, axes[i], drives[i]);
  text +=
      "\n# frames: x, y, z, roll, pitch, yaw, at zero, in that of the joint before; of the first one, in the base\n";
  text += "[chain]\nbase = " + toml_text(arm.base) + "\ntip = " + toml_text(arm.tip) + "\n";
  text += "flange = " + toml_pose(arm.flange) + "  # of the tip in the last joint\n\n[chain.joints]\n";
  for (std::size_t i = 0; i < axes.size(); ++i) {
    const kinematics::ChainJoint& joint = arm.joints[i];
    text += toml_key(axes[i].name) + " = { frame = " + toml_pose(joint.frame) + ", axis = " + toml_array(joint.axis);
    text += joint.slides ? ", kind = \"slides\" }" : " }";
    text += "  # URDF line " + std::to_string(arm.axes[i].line) + "\n";
  }
  return text;
}

}  // namespace mrroc::cli
