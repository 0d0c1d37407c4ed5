#pragma once

#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "config/deployment.hpp"
#include "edp/check/urdf.hpp"
#include "messages/geometry_msgs/transform_stamped.hpp"

namespace mrroc::cli {

/// Pose of the frame `child` in the frame `parent`, without a time.
messages::geometry_msgs::TransformStamped transform_of(std::string parent, std::string child, const Pose& pose);

/// The frames of one robot for tf2: the links of its URDF, its base in the world or on the tool of the robot that
/// carries it, its flange and its tool. Frames have the names of the links behind `prefix`. One thread.
class RobotFrames {
 public:
  using Transforms = std::vector<messages::geometry_msgs::TransformStamped>;

  /// `world`: name of the frame in which the base is placed. A robot without a URDF has the frames `base`, its flange
  /// and its tool alone. Throws config::ConfigurationError: the URDF or the parameter file is invalid.
  RobotFrames(const config::RobotEntry& robot, std::string prefix, const std::string& world);

  /// Those that never move, without times.
  const Transforms& fixed() const noexcept { return fixed_; }
  /// Appends the others. `joints`: positions of the axes, rad or m; `tool`: pose of the tool in the base frame,
  /// `tool_in_flange`: in the flange frame. Links behind a joint that is neither an axis nor mimics one are left out.
  void append(const messages::builtin_interfaces::Time& stamp, std::span<const double> joints, const Pose& tool,
              const Pose& tool_in_flange, Transforms& transforms) const;

  /// Names of the axes, which are those of the URDF's joints.
  const std::vector<std::string>& joints() const noexcept { return joints_; }
  std::string base() const { return prefix_ + base_; }
  std::string tool() const;
  std::string flange() const { return prefix_ + name_ + "_flange"; }
  /// The URDF's text, in which the paths of meshes are URIs of this machine's files; empty without a URDF.
  const std::string& description() const noexcept { return description_; }

 private:
  void add(const edp::Urdf::Joint& joint, const Pose& pose, Transforms& transforms) const;

  std::string name_;
  std::string prefix_;
  std::string base_ = "base";
  std::vector<std::string> joints_;
  std::optional<edp::Urdf> urdf_;
  std::string description_;
  Transforms fixed_;
};

}  // namespace mrroc::cli
