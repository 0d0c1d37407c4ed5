#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace mrroc::netft {

/// Largest answer that is read, bytes; a Net F/T's configuration page has some 5,000.
inline constexpr std::size_t kMaxAnswer = 64 * 1024;

/// Reads `path` from the HTTP server `host`:`port`, with HTTP/1.0, within `timeout` s in all; a name server may take
/// longer. Returns the body. Throws HardwareError(sensor_hardware), which names the address: no connection, no complete
/// answer in time, an answer of more than kMaxAnswer bytes, another status than 200, an encoding. Any thread; waits.
std::string http_get(const std::string& host, std::uint16_t port, const std::string& path, double timeout);

/// The body of a complete HTTP answer; `place` is the address in messages. Throws as http_get.
std::string body_of(const std::string& answer, const std::string& place);

}  // namespace mrroc::netft
