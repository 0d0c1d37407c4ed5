#pragma once

#include <filesystem>
#include <string>
#include <vector>

/// Where the types and the programs of a deployment lie: in folders given by the environment as lists with ':' between,
/// else in the installation (or build folder, which has its layout) of the running executable. The first folder that
/// holds what is looked for is taken.
namespace mrroc::config {

/// Folders with robots/TYPE/ and sensors/TYPE/: $MRROC_SHARE, else share/mrroc of the prefix under which the
/// running executable is in bin/ or libexec/mrroc/.
std::vector<std::filesystem::path> share_directories();

/// Folders of executables: $MRROC_PROGRAMS, else that of the running one, then libexec/mrroc of the same prefix.
std::vector<std::filesystem::path> program_directories();

/// Names of the robot (sensor) types that there are, sorted.
std::vector<std::string> robot_types();
std::vector<std::string> sensor_types();

/// Path of KIND/TYPE/NAME, with KIND `robots` or `sensors`; of an unknown type, in the first folder.
std::filesystem::path type_file(const std::string& kind, const std::string& type, const std::string& name);

/// Puts both lists into the environment: processes started from now on look in the same folders.
void hand_down_directories();

/// Which of the deployment's hosts this machine is: $MRROC_HOST; empty: the runner's machine.
std::string this_host();
/// Makes this process and those started from now on processes of that host.
void hand_down_host(const std::string& name);

}  // namespace mrroc::config
