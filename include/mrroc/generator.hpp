#pragma once

#include <memory>
#include <string>
#include <utility>

#include "mrroc/condition.hpp"

namespace mrroc {

/// f_e* and f_T of one motion: writes every robot's command from c^i, e^i, v^i, and says when the motion is over.
/// Derive, keep references to the robots and sensors, implement `next_state()`; the same generator runs in an ECP and
/// in the MP. Task's thread only.
class Generator {
 public:
  explicit Generator(std::string name) : name_(std::move(name)) {}
  virtual ~Generator() = default;

  const std::string& name() const noexcept { return name_; }

  /// Called once per Move, when e^{i0}, v^{i0} are there, before the first step: plan from `state()`'s desired values.
  /// May allocate; may throw NonFatalError.
  virtual void start() {}
  /// Called after every pause and after a late command, the robots at rest: plan the rest of the motion. By default it
  /// is started again.
  virtual void resume() { start(); }
  /// The operator pauses while robots move. True: from now on `next_state()` leads them to rest along their way, until
  /// `resume()`. False, the default: it cannot; every robot brakes on its own, as fast as its limits allow, and robots
  /// that move together leave their common way. Called once per pause; must not allocate.
  virtual bool brake() { return false; }
  /// f_T: the motion is over on its own. Evaluated once per step, before `next_state()`.
  virtual bool terminal_condition() { return false; }
  /// f_e*: writes `robot.command()` of every robot it moves; a robot it leaves alone holds. Must not allocate.
  virtual void next_state() = 0;

  /// Adds a terminal condition; several are alternatives (`||`).
  template <ConditionType C>
  Generator& until(C condition) {
    add_condition(std::make_shared<C>(std::move(condition)));
    return *this;
  }
  /// The condition given with `until`, null when there is none.
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
