#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "links/ros2/node.hpp"
#include "messages/cdr_writer.hpp"

namespace mrroc::ros2 {

/// A publisher of encoded messages. One thread.
class RawPublisher {
 public:
  /// `topic`: absolute, "/arm/joint_states". `type`: "sensor_msgs/msg/JointState". Throws SystemError (resources). The
  /// node outlives it, and shows it from its next `announce` on.
  RawPublisher(Node& node, const std::string& topic, std::string_view type, std::string_view type_hash,
               Durability durability);
  ~RawPublisher();
  RawPublisher(RawPublisher&&) noexcept;

  /// `cdr`: with its header. A subscriber that does not acknowledge holds it up for 0.1 s at most; the message is lost
  /// for that one then. Returns whether it was sent.
  bool write(std::vector<std::byte> cdr) noexcept;
  /// Whether any subscriber receives the messages.
  bool is_received() const noexcept;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// A publisher of one kind of message. One thread.
template <class Message>
class Publisher {
 public:
  /// As of RawPublisher.
  Publisher(Node& node, const std::string& topic, Durability durability = Durability::none)
      : raw_(node, topic, Message::kType, Message::kHash, durability) {}

  bool publish(const Message& message) { return raw_.write(messages::to_cdr(message)); }
  bool is_received() const noexcept { return raw_.is_received(); }

 private:
  RawPublisher raw_;
};

}  // namespace mrroc::ros2
