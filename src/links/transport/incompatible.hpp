#pragma once

#include <cstdint>
#include <string>

namespace mrroc::links {

/// Text for a DDS match that failed by quality-of-service policy `policy` (0: none did, empty text).
std::string incompatible(const std::string& topic, std::uint32_t policy);

}  // namespace mrroc::links
