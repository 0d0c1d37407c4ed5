#pragma once

#include <filesystem>
#include <string>

namespace mrroc::links {

/// How Cyclone loads its authentication plug-in (DDS Security 1.1, 8.3): the values of the participant's properties
/// dds.sec.auth.library.*. The functions are defined in this program and work around three defects of Cyclone (0.10.2,
/// Debian 12; by its source two of them are in 11.0, too). With the first two, anyone who reaches a process's port
/// could end or block the process without any key, because the hand-shake is not signed yet.
///
/// - A remote identity is refused after an early hand-shake request: Cyclone takes the length of the class of an empty
///   authentication request token, a null pointer (11.0, too). Our functions call the plug-in's, and fill in an empty
///   class where an identity is refused.
/// - A hand-shake is not complete after 100 s: Cyclone removes its timer from a heap twice, and its hand-shake thread
///   loops endlessly (eclipse-cyclonedds/cyclonedds#1548, repaired in 0.10.3). That timer is never set here:
///   `start_timeout` ends the wait for a peer that does not finish, and an unknown participant is removed when its
///   lease ends.
/// - The final message of a hand-shake is lost, on the network or in a full buffer of a busy machine (11.0, too): its
///   sender reports to itself, before it sends the message, that the peer's session keys have arrived. It ends the
///   hand-shake 0.1 s later and ignores the peer's reply, which the peer repeats every second. The peer never accepts
///   the sender. Here that report is dropped: the sender answers a repeated reply with the final message again, and
///   ends the hand-shake after the peer's session keys have arrived.
struct AuthenticationLibrary {
  std::string path;
  std::string init;
  std::string finalize;
};

/// Opens the plug-in `library` (libdds_security_auth.so), once in a process. Throws SystemError (resources) when it
/// cannot be opened or is not such a plug-in. Any thread.
AuthenticationLibrary authentication_library(const std::filesystem::path& library);

}  // namespace mrroc::links
