#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "mrroc/types.hpp"

namespace mrroc::edp {

/// The kinematics of a URDF: links and joints, their positions and motions. Masses and shapes are ignored.
/// Configuration time only.
class Urdf {
 public:
  enum class Type { fixed, revolute, continuous, prismatic };
  struct Mimic {
    std::string joint;
    double multiplier = 1;
    double offset = 0;
  };
  struct Joint {
    std::string name;
    Type type = Type::fixed;
    std::string parent, child;                        ///< links
    Pose origin = Pose::Identity();                   ///< of the joint and of the child at position 0, in the parent
    Eigen::Vector3d axis = Eigen::Vector3d::UnitX();  ///< unit vector in the joint's frame
    std::optional<double> lower, upper, velocity;     ///< rad or m, 1/s; nothing: endless, or not in the file
    std::optional<double> acceleration;               ///< 1/s2, of the attribute drake:acceleration
    std::optional<double> effort;                     ///< N m or N; nothing: not in the file
    std::optional<Mimic> mimic;
    int line = 0;
    int limit_line = 0;  ///< of the element <limit>; 0: it is missing
  };
  /// Positions of joints by name, rad or m.
  using Positions = std::map<std::string, double>;

  /// Whether a joint that moves without `<limit>`, or with an incomplete one, is refused or has no value there.
  enum class Limits { required, optional };

  /// Reads a file. Defaults are those of the specification (http://wiki.ros.org/urdf/XML/joint): origin identity, axis
  /// 1 0 0, lower and upper limit 0, multiplier 1, offset 0. Elements without meaning for the type of a joint are not
  /// read: axis, limit, dynamics and mimic of a fixed joint, the range of a continuous one. Elements that the
  /// specification does not have are ignored. Throws ConfigurationError with file and line: what `read_xml` refuses, no
  /// `<robot>`, xacro that is not expanded, a name twice, a joint of another type, with
  /// Limits::required a joint that moves without effort and velocity, a joint's link that is not in the file, links
  /// that are not a tree, numbers that core::to_finite refuses.
  static Urdf load(const std::filesystem::path& file, Limits limits = Limits::required);

  const std::filesystem::path& file() const noexcept { return file_; }
  bool has_link(const std::string& name) const { return links_.contains(name); }
  /// Names of all links, sorted.
  std::vector<std::string> links() const;
  /// Line of a link's element.
  int line_of_link(const std::string& name) const { return links_.at(name); }
  /// In file order.
  const std::vector<Joint>& joints() const noexcept { return joints_; }
  /// Null when it does not exist.
  const Joint* joint(const std::string& name) const;
  /// The joint that carries a link; null for the root.
  const Joint* joint_above(const std::string& link) const;
  /// Pose of a link of this file in the root link's frame. Throws ConfigurationError when a joint on the path
  /// moves and is neither in `positions` nor follows one that is.
  Pose pose(const std::string& link, const Positions& positions) const;

 private:
  double position(const Joint& joint, const Positions& positions) const;

  std::filesystem::path file_;
  std::map<std::string, int> links_;  ///< name, line
  std::vector<Joint> joints_;
};

}  // namespace mrroc::edp
