#pragma once

#include <string>

namespace mrroc::config {

enum class HostPlace { local, remote, unknown };

/// The location of the machine with this name or numeric address: `local` if it is this machine's own name or one of
/// its addresses is a loopback address or one of this machine's interfaces, `unknown` if the name does not resolve.
/// Asks the resolver, so it may take seconds.
HostPlace locate_host(const std::string& host);

}  // namespace mrroc::config
