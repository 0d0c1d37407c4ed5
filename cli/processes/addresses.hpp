#pragma once

#include <netinet/in.h>

#include <string>

namespace mrroc::cli {

/// The IPv4 address of a host name or numeric address. Throws std::runtime_error when it does not resolve. Calls the
/// resolver, so it may take seconds.
in_addr ipv4_of(const std::string& host);

/// This machine's own address on the route to `peer`, as the kernel routes it; sends nothing. Throws std::runtime_error
/// when there is no route.
in_addr own_address_towards(in_addr peer);

std::string to_text(in_addr address);

}  // namespace mrroc::cli
