#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "cli/robot/import/findings.hpp"

namespace mrroc::cli {

/// Finds the files of a URDF's meshes. Configuration time only.
class MeshPaths {
 public:
  /// `findings` must outlive this object.
  MeshPaths(const std::filesystem::path& urdf, Findings& findings);

  /// The file of a reference: `package://PACKAGE/PATH` (also `model://`), `file:///PATH`, or a path from the URDF's
  /// folder. A package is a folder of that name in a folder above the URDF, in ROS_PACKAGE_PATH or in share/ of
  /// AMENT_PREFIX_PATH; without one, PATH in a folder above the URDF is taken with a warning. Throws
  /// config::ConfigurationError with `line`: no such package or file, a xacro expression.
  std::filesystem::path find(const std::string& reference, int line);

 private:
  std::filesystem::path in_package(const std::string& reference, const std::filesystem::path& path, int line);
  std::vector<std::filesystem::path> package_folders(const std::string& package) const;

  std::filesystem::path urdf_;
  Findings& findings_;
};

}  // namespace mrroc::cli
