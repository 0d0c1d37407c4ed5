#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace mrroc::links {

/// The log of Cyclone DDS. It replaces stderr, where each malformed datagram would be one line and a flood of them
/// would fill a disk: every message is counted and the last 32, cut to 200 characters, are kept. One log per process;
/// `Domain` installs it.
void install_dds_log();

/// Messages since the start of the process. Any thread.
std::uint64_t dds_log_count() noexcept;

/// The messages that are kept, oldest first. Any thread.
std::vector<std::string> dds_log_messages();

}  // namespace mrroc::links
