#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace mrroc::messages {

/// One message of src/messages/msg, for programs that choose it by name.
struct MessageType {
  std::string_view name;                  ///< "sensor_msgs/msg/JointState"
  std::string_view hash;                  ///< "RIHS01_" and 64 digits: REP 2016
  std::string_view (*schema)() noexcept;  ///< its ros2msg text
  /// Decodes an encoding of either byte order and encodes the message again. Throws CdrError.
  std::vector<std::byte> (*recode)(std::span<const std::byte> bytes);
  /// The message of an encoding as JSON on one line. Throws CdrError.
  std::string (*json)(std::span<const std::byte> bytes);
};

/// All of them, each behind those that it contains.
std::span<const MessageType> message_types() noexcept;

}  // namespace mrroc::messages
