#pragma once

#include <filesystem>
#include <string>

namespace mrroc::links {

/// How Cyclone loads its authentication plug-in (DDS Security 1.1, 8.3): the values of the participant's properties
/// dds.sec.auth.library.*. The functions are defined in this program and work around two defects of Cyclone (0.10.2,
/// Debian 12), with which anyone who reaches a process's port could end or block the process without any key. The
/// hand-shake is not signed yet.
///
/// - A remote identity is refused after an early hand-shake request: Cyclone takes the length of the class of an empty
///   authentication request token, a null pointer (according to its source also in 11.0). Our functions call the
///   plug-in's, and fill in an empty class where an identity is refused.
/// - A hand-shake is not complete after 100 s: Cyclone removes its timer from a heap twice, and its hand-shake thread
///   loops endlessly (eclipse-cyclonedds/cyclonedds#1548, repaired in 0.10.3). That timer is never set here:
///   `start_timeout` ends the wait for a peer that does not finish, and an unknown participant is removed when its
///   lease ends.
struct AuthenticationLibrary {
  std::string path;
  std::string init;
  std::string finalize;
};

/// Opens the plug-in `library` (libdds_security_auth.so), once in a process. Throws SystemError (resources) when it
/// cannot be opened or is not such a plug-in. Any thread.
AuthenticationLibrary authentication_library(const std::filesystem::path& library);

}  // namespace mrroc::links
