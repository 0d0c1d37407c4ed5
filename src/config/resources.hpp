#pragma once

#include <filesystem>
#include <string>
#include <vector>

/// The folders of the types and the programs of a deployment: lists with ':' between in the environment, else the
/// installation (or build folder, which has the same layout) of the running executable. The first folder that contains
/// the requested item is used.
namespace mrroc::config {

/// The user's own folder, as the XDG Base Directory Specification places it: $XDG_DATA_HOME/mrroc, else
/// ~/.local/share/mrroc; empty without a home.
std::filesystem::path user_share();

/// Folders with robots/TYPE/, sensors/TYPE/ and drivers/NAME/: $MRROC_SHARE, else share/mrroc of the prefix under which
/// the running executable is in bin/ or libexec/mrroc/, then the user's folder if there is one.
std::vector<std::filesystem::path> share_directories();

/// Folders of executables: $MRROC_PROGRAMS, else that of the running one, then libexec/mrroc of the same prefix.
std::vector<std::filesystem::path> program_directories();

/// Path of the executable of this name in one of them; empty: in no folder.
std::filesystem::path find_program(const std::string& name);

/// Folders with the plug-ins of KIND (`drivers`, `sensors`), NAME.so: KIND in each folder of $MRROC_PLUGINS, else in
/// lib/mrroc of the prefix, then in lib/mrroc beside the user's share folder.
std::vector<std::filesystem::path> plugin_directories(const std::string& kind);

/// Names of the installed robot types, sensor types, drivers, sorted.
std::vector<std::string> robot_types();
std::vector<std::string> sensor_types();
std::vector<std::string> driver_names();

/// Drivers are also searched in share/mrroc of the running executable's prefix, whatever the environment says.
///
/// Path of KIND/TYPE/NAME, with KIND `robots`, `sensors` or `drivers`; of an unknown type, in the first folder.
std::filesystem::path type_file(const std::string& kind, const std::string& type, const std::string& name);

/// Puts the three lists into the environment: processes started from now on search the same folders.
void hand_down_directories();

/// The name of this machine among the deployment's hosts: $MRROC_HOST; empty: the runner's machine.
std::string this_host();
/// Makes this process and those started from now on processes of that host.
void hand_down_host(const std::string& name);

}  // namespace mrroc::config
