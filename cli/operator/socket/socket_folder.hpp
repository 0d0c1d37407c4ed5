#pragma once

#include <sys/types.h>

#include <filesystem>
#include <string>
#include <vector>

namespace mrroc::cli {

/// The folder of the operator sockets of this user: `$MRROC_RUNTIME_DIR`, else `$XDG_RUNTIME_DIR/mrroc`, or
/// `/tmp/mrroc-UID` where neither variable is set; UID is that of the user outside a user namespace. Created with mode
/// 0700 when it is missing. Throws std::runtime_error when it cannot be created, belongs to another user, or other
/// users may enter it.
std::filesystem::path make_socket_folder();

/// The sockets of this user's runs, by name: in the first of these folders alone, or in both others. A socket that no
/// process listens on is removed.
std::vector<std::filesystem::path> operator_sockets();

/// A new socket of this path, mode 0600, that listens and does not block; it appears when it listens. Paths may be
/// longer than a socket address. Throws std::runtime_error with the path and the reason.
int listen_at(const std::filesystem::path& path);
/// A connection to it, or -1 with errno.
int connect_to(const std::filesystem::path& path) noexcept;

}  // namespace mrroc::cli
