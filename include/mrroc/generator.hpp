#pragma once

#include <memory>
#include <string>
#include <utility>

#include "mrroc/condition.hpp"

namespace mrroc {

class Superior;

/// f_e* and f_T of one motion: writes every robot's command from c^i, e^i, v^i, and decides when the motion ends.
/// Derive from it, keep references to the robots and sensors, and implement `next_state()`. The same generator runs in
/// an ECP and in the MP. Task's thread only.
class Generator {
 public:
  explicit Generator(std::string name) : name_(std::move(name)) {}
  virtual ~Generator() = default;

  const std::string& name() const noexcept { return name_; }

  /// Called once per Move, after e^{i0}, v^{i0} have arrived and before the first step: plan from `state()`'s desired
  /// values. May allocate; may throw NonFatalError.
  virtual void start() {}
  /// Called after every pause and after a late command, with the robots at rest: plan the rest of the motion. The
  /// default starts the motion again.
  virtual void resume() { start(); }
  /// The operator pauses while robots move. True: from now on `next_state()` brings them to rest on their path, until
  /// `resume()`. False, the default: the generator cannot do that. Every robot then brakes on its own, as fast as its
  /// limits allow, and robots that move together leave their common path. Called once per pause; must not allocate.
  virtual bool brake() { return false; }
  /// Whether the operator's speed scales this motion. True, the default: Move stretches the time between the states
  /// that `next_state()` commands, so the robots pass the same path more slowly, and `state()` shows `next_state()` its
  /// own desired values. False: the motion follows something that has its own time (a moving frame, a hand, a spring),
  /// so it is executed as commanded.
  virtual bool scales_with_speed() const { return true; }
  /// The MP that takes part in the Move of this generator, in an ECP: see `Coordinated`. Null, the default: none does.
  virtual Superior* followed() noexcept { return nullptr; }
  /// f_T: the motion has ended on its own. Evaluated once per step, before `next_state()`.
  virtual bool terminal_condition() { return false; }
  /// f_e*: writes `robot.command()` of every robot that it moves; the other robots hold. Must not allocate.
  virtual void next_state() = 0;
  /// Called once when a Move that has called `start()` ends, for any reason.
  virtual void finish() noexcept {}

  /// Adds a terminal condition; several are alternatives (`||`).
  template <ConditionType C>
  Generator& until(C condition) {
    add_condition(std::make_shared<C>(std::move(condition)));
    return *this;
  }
  /// The condition given with `until`; null without one.
  const std::shared_ptr<Condition>& condition() const noexcept { return condition_; }

 protected:
  Generator(const Generator&) = default;
  Generator(Generator&&) = default;
  Generator& operator=(const Generator&) = default;
  Generator& operator=(Generator&&) = default;

 private:
  void add_condition(std::shared_ptr<Condition> condition);

  std::string name_;
  std::shared_ptr<Condition> condition_;
};

}  // namespace mrroc
