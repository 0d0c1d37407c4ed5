#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace mrroc::recording {

/// The messages of the last seconds of a run (`mrroc run --record-last`), in the order in which they came. One thread.
class RecentMessages {
 public:
  struct Message {
    std::string topic;
    std::string_view type, schema;  ///< of the generated messages
    std::uint64_t time = 0;         ///< ns
    std::vector<std::byte> cdr;
  };

  /// `span`: ns before the newest message.
  explicit RecentMessages(std::uint64_t span) : span_(span) {}

  void add(Message message) {
    newest_ = std::max(newest_, message.time);
    messages_.push_back(std::move(message));
    while (messages_.front().time + span_ < newest_) messages_.pop_front();
  }
  const std::deque<Message>& messages() const noexcept { return messages_; }

 private:
  std::uint64_t span_;
  std::uint64_t newest_ = 0;
  std::deque<Message> messages_;
};

}  // namespace mrroc::recording
