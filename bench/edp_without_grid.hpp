#pragma once

#include "drivers/loopback/loopback_hardware.hpp"
#include "edp/command/effector.hpp"
#include "edp/servo/servo.hpp"
#include "mrroc/robot_link.hpp"
#include "robots/irb6/irb6_model.hpp"

/// An EDP of an IRb-6 that ticks when a command comes, for benchmarks of what a step of Move computes.
namespace mrroc {

inline RobotModels load_models() { return load_irb6(MRROC_SOURCE_DIR "/robots/irb6/irb6.toml"); }

/// All of an EDP but its links and its grid.
class Edp {
 public:
  explicit Edp(double period)
      : hardware_(*models_.front(), period),
        servo_(model_set_, hardware_, period, channel_),
        effector_(model_set_, period, channel_) {
    effector_.enable(true);
    servo_.tick(tick_);
  }

  /// `reply(state, number)` is called for each answer.
  template <class Reply>
  void execute(const RobotCommand& command, std::uint64_t number, Reply reply) {
    if (effector_.accept(command, number, answer_)) return reply(answer_.state, number);
    servo_.tick(++tick_);
    while (effector_.poll(answer_)) reply(answer_.state, answer_.command);
  }

 private:
  RobotModels models_ = load_models();
  edp::ModelSet model_set_{models_};
  edp::LoopbackHardware hardware_;
  edp::ServoChannel channel_;
  edp::Servo servo_;
  edp::Effector effector_;
  Tick tick_ = 0;
  edp::Reply answer_;
};

/// A robot's link to an EDP in the same thread.
class NoLink final : public RobotLink {
 public:
  explicit NoLink(double period) : edp_(period) {}
  void send(const RobotCommand& command) override {
    edp_.execute(command, ++number_, [this](const RobotState& state, std::uint64_t) { state_ = state; });
  }
  void receive(RobotState& state) override { state = state_; }

 private:
  Edp edp_;
  std::uint64_t number_ = 0;
  RobotState state_;
};

}  // namespace mrroc
