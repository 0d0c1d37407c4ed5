#pragma once

#include <filesystem>
#include <string>

namespace mrroc::links {

/// How Cyclone loads its authentication plug-in (DDS Security 1.1, 8.3): the values of the participant's properties
/// dds.sec.auth.library.*. The functions are this program's own and repair two defects of Cyclone (0.10.2, Debian 12),
/// by which whoever reaches a process's port, without any key, could end or block it. The hand-shake is not signed yet.
///
/// - A remote identity is refused, and a hand-shake request has come early: Cyclone takes the length of the class of
///   an authentication request token that no one has filled in, a null pointer (by its source in 11.0, too). Ours call
///   the plug-in's, and fill in an empty class where an identity is refused.
/// - A hand-shake is not done after 100 s: Cyclone takes its timer out of a heap twice, and its thread of hand-shakes
///   runs in a circle forever (eclipse-cyclonedds/cyclonedds#1548, repaired in 0.10.3). That timer is never set here: a
///   peer that does not finish is given up by `start_timeout`, a stranger goes when its lease ends.
struct AuthenticationLibrary {
  std::string path;
  std::string init;
  std::string finalize;
};

/// Opens the plug-in `library` (libdds_security_auth.so), once in a process. Throws SystemError (resources) where it
/// cannot be opened or is none. Any thread.
AuthenticationLibrary authentication_library(const std::filesystem::path& library);

}  // namespace mrroc::links
