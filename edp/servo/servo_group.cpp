// Stops that the robots of one motion have in common.
#include <utility>

#include "edp/servo/servo.hpp"

namespace mrroc::edp {

namespace {

bool is_commanded_motion(Macrostep::Kind kind) noexcept {
  return kind == Macrostep::Kind::path || kind == Macrostep::Kind::force;
}

}  // namespace

/// The others of this motion stop from the next tick on.
void Servo::give_up_group(Tick tick) noexcept {
  group_.announce(active_.stop.group, tick);
  const ErrorReport postponed = std::exchange(postponed_, {});
  if (postponed.error_class != ErrorClass::none && fault_.code == ErrorCode::none) count_interruption(postponed);
}

bool Servo::moves_in_group() const noexcept {
  return active_.stop.group != 0 && is_commanded_motion(active_.kind) && (running_ || !desired_.at_rest());
}

/// The motion ends, and the next macrostep is of another one: the others have come to the same end.
bool Servo::continues_elsewhere() const noexcept {
  constexpr double kSkew = 10;  // ticks, between robots with clocks of their own
  const Macrostep* const next = channel_.macrosteps.front();
  const bool ends = !running_ || now_ + kSkew >= static_cast<double>(active_.start + active_.steps);
  return ends && next != nullptr && next->epoch == epoch_ && is_commanded_motion(next->kind) &&
         next->stop.group != active_.stop.group;
}

/// One of the robots that share this motion has stopped in an earlier tick.
void Servo::stop_with_group(Tick tick) noexcept {
  const bool own = postponed_.error_class != ErrorClass::none;
  if (!own && continues_elsewhere()) return;
  if (!group_.is_due(active_.stop.group, tick)) {
    if (own) interrupt(std::exchange(postponed_, {}), then_, tick);  // another motion has begun in between
    return;
  }
  give_up_group(tick);
  if (!moves_in_group()) return;
  if (active_.ticket != 0) finished_ = active_.ticket;
  brake_with_group();
  braking_ = false;
  joined_ = !own;
}

/// From the set-point of the last tick, in the middle of a macrostep: in step where the limits allow it.
void Servo::brake_with_group() noexcept {
  const bool in_step = moves_in_group() && active_.kind == Macrostep::Kind::path && active_.stop.ticks > 0 &&
                       group_.passes(desired_, active_.stop, switches_.on());
  brake(then_);
  if (in_step) brake_in_step(active_.stop);
}

/// As the other robots of its Move do.
void Servo::brake_in_step(const CommonStop& common) noexcept {
  common_stop_.plan(desired_, common, period_);
  in_step_ = true;
  active_.steps = common_stop_.ticks();
  active_.to = common_stop_.end();
}

}  // namespace mrroc::edp
