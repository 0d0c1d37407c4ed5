#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "cli/robot/import/findings.hpp"
#include "mrroc/types.hpp"

namespace mrroc::cli {

/// A visible or colliding shape of a link.
struct UrdfShape {
  enum class Kind { box, cylinder, capsule, sphere, mesh };
  Kind kind = Kind::box;
  Eigen::Vector3d size = Eigen::Vector3d::Zero();   ///< m: box: edges; others: radius, length without caps, 0
  std::string mesh;                                 ///< reference, as in the file
  Eigen::Vector3d scale = Eigen::Vector3d::Ones();  ///< of the mesh
  Pose origin = Pose::Identity();                   ///< in the link's frame
  std::optional<Eigen::Vector4d> colour;            ///< red, green, blue, alpha, each 0..1
  int line = 0;
};

/// Mass and inertia as the file has them, not checked.
struct UrdfInertial {
  Pose origin = Pose::Identity();  ///< of the centre of mass and the axes of the inertia, in the link's frame
  double mass = 0;                 ///< kg
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();  ///< kg m2
  int line = 0;
};

struct UrdfBody {
  std::string name;
  int line = 0;
  std::optional<UrdfInertial> inertial;
  std::vector<UrdfShape> visuals, collisions;
};

/// Masses and shapes of a URDF that edp::Urdf has accepted.
struct UrdfBodies {
  std::string robot;             ///< name of the robot; may be empty
  std::vector<UrdfBody> bodies;  ///< one for each link, in file order

  const UrdfBody& body(const std::string& link) const;
};

/// Reads them. Undeclared name spaces are warned of in `findings`. Throws config::ConfigurationError with file and
/// line: numbers that are not valid, a shape without geometry or of an unknown kind, sizes or scales that are zero or
/// not positive. Configuration time only.
UrdfBodies read_urdf_bodies(const std::filesystem::path& file, Findings& findings);

}  // namespace mrroc::cli
