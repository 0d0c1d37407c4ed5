#pragma once

#include <cstdint>

#include "mrroc/superior_link.hpp"

namespace mrroc {

/// c_0 as one ECP sees it in equation (11) of the paper, e_j^{i+1} = f*(c_0, c_j, e_j, v): the MP's command for the
/// robot of this ECP at this step. A `Coordinated` generator reads it; the Move that runs the generator does the rest
/// of what is here. Task's thread; allocates nothing.
class Superior {
 public:
  /// What has come from the MP since the last call of `take`.
  enum class News : std::uint8_t {
    nothing,
    command,  ///< a command of this step, in `command()`
    plan,     ///< the MP asks for the state from which its generator plans: at the start of its Move or Wait, or after
              ///< a pause or a late command
    change,   ///< a change of the robot itself, in `command()`
    end       ///< its Move has ended
  };

  explicit Superior(SuperiorLink& link) : link_(&link) {}

  /// The MP's command for this step: e^{i+1} as the MP wishes it. Before the first one: a query.
  const RobotCommand& command() const noexcept { return command_; }
  /// The MP's Move in which this one took part has ended, and no other has begun since. A Wait of the MP only holds.
  bool ended() const noexcept { return ended_; }

  // ---- used by Move
  /// The commands of the MP are for this Move, until `leave`.
  void join();
  /// Takes the next news; does not wait. All but `nothing` and `end` are to be
  /// answered.
  News take();
  void wait() { link_->wait(); }
  /// Answers the MP with the robot's state after the exchange with the EDP.
  void answer(const RobotState& state);
  /// Ends it. A command that was taken and not executed is answered with `state` and `error`, so that the MP throws the
  /// error, or without one plans again from that state. Throws what `SuperiorLink::reply` does.
  void leave(const RobotState& state, const ErrorReport& error);

 private:
  void reply(const RobotState& state, Coordination coordination, const ErrorReport& error);

  SuperiorLink* link_;
  RobotCommand command_;
  RobotState reply_;
  bool pending_ = false;  // a command is not answered yet
  bool ended_ = false;
};

}  // namespace mrroc
