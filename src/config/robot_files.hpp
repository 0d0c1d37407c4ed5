#pragma once

#include <filesystem>
#include <string>

namespace mrroc::config {

class Table;

/// The files that describe one robot, absolute.
struct RobotFiles {
  std::filesystem::path parameters;  ///< TOML: its axes and its geometry
  std::filesystem::path mjcf;        ///< its body in the simulated world
  std::filesystem::path urdf;        ///< its geometry for generic tools; optional
  std::filesystem::path drives;      ///< the table of its drives on a CAN bus
};

/// The files of a robot of type TYPE with the parameter file DIR/STEM.toml: that file, DIR/STEM.xml, DIR/STEM.urdf and
/// DIR/STEM_drives.toml. Without DIR/STEM.xml the body is that of robots/TYPE/TYPE.xml, without DIR/STEM_drives.toml
/// the drives are those of robots/TYPE/TYPE_drives.toml. With `parameters` empty all files are those of robots/TYPE.
RobotFiles robot_files(const std::string& type, const std::filesystem::path& parameters = {});

/// `parameters`, or when it is empty the installed robots/TYPE/TYPE.toml.
std::filesystem::path parameter_file(const std::string& type, const std::filesystem::path& parameters);

/// For types whose loader reads one fixed file: throws ConfigurationError unless `parameters` is empty.
void refuse_parameters(const std::filesystem::path& parameters);

/// Resolves the key `parameters` of a robot's table: a path relative to the deployment, or else to robots/TYPE. Throws
/// ConfigurationError when neither file can be read, its axes are wrong, or its `type` is another one.
std::filesystem::path find_parameters(const Table& table, const std::string& type);

}  // namespace mrroc::config
