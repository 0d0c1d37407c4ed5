#pragma once

#include "links/exchange/robot_responder.hpp"
#include "mrroc/stopped.hpp"
#include "mrroc/superior_link.hpp"
#include "process/process.hpp"

namespace mrroc::ecp {

/// The MP's commands to the robot of this ECP, for a Move in which the MP takes part. Task's thread.
class SuperiorCommands final : public SuperiorLink {
 public:
  SuperiorCommands(process::Process& process, links::RobotResponder& mp) : process_(process), mp_(mp) {}

  /// Whether such a Move is under way: the commands are neither relayed nor refused meanwhile.
  bool joined() const noexcept { return joined_; }

  void join() override { joined_ = true; }
  void leave() noexcept override { joined_ = false; }
  bool take(RobotCommand& command) override { return mp_.take(command, sequence_); }
  void reply(const RobotState& state) override { mp_.reply(state, sequence_); }
  void wait() override {
    if (process_.clock().wait(kNever) == clock::Wake::interrupted) throw Stopped{};
  }

 private:
  process::Process& process_;
  links::RobotResponder& mp_;
  std::uint64_t sequence_ = 0;
  bool joined_ = false;
};

}  // namespace mrroc::ecp
