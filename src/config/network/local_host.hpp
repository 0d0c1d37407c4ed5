#pragma once

#include <string>

namespace mrroc::config {

enum class HostPlace { local, remote, unknown };

/// Where the machine of this name or numeric address is: `local` if it is this machine's own name or one of its
/// addresses is a loopback address or one of this machine's interfaces, `unknown` if the name does not resolve. Asks
/// the resolver, so it may take seconds.
HostPlace locate_host(const std::string& host);

}  // namespace mrroc::config
