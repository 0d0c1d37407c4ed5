#pragma once

#include <functional>
#include <stdexcept>
#include <vector>

#include "mrroc/stopped.hpp"
#include "mrroc/superior_link.hpp"

namespace mrroc::fakes {

/// What an MP sends, item by item, and what it is answered. Without more items the ECP is stopped where it waits.
class FakeMp : public SuperiorLink {
 public:
  struct Item {
    bool sent = true;  ///< false: nothing has come when the ECP looks
    RobotCommand command;
  };

  void join() override { joined = true; }
  void leave() noexcept override { joined = false; }
  bool take(RobotCommand& command) override {
    if (!joined) throw std::logic_error("taken without having joined");
    if (next_ == items.size() && make) items.push_back({true, make(replies)});
    if (next_ == items.size()) return false;
    const Item& item = items[next_++];
    if (!item.sent) return false;
    if (pending_) throw std::logic_error("a command before the answer to the last one");
    pending_ = true;
    command = item.command;
    return true;
  }
  void reply(const RobotState& state) override {
    if (!pending_) throw std::logic_error("an answer without a command");
    pending_ = false;
    replies.push_back(state);
  }
  void wait() override {
    if (next_ == items.size()) throw Stopped{};
  }

  std::vector<Item> items;
  /// Makes further items from the answers so far; without it the items end.
  std::function<RobotCommand(const std::vector<RobotState>& replies)> make;
  std::vector<RobotState> replies;
  bool joined = false;

 private:
  std::size_t next_ = 0;
  bool pending_ = false;
};

inline FakeMp::Item item(CommandKind kind) {
  FakeMp::Item made;
  made.command.kind = kind;
  return made;
}

}  // namespace mrroc::fakes
