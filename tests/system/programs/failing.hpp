#pragma once

#include "mrroc/errors.hpp"
#include "mrroc/generators/tool_velocity.hpp"

namespace mrroc::test {

/// Runs the belt, and throws at step 20.
class Failing : public Generator {
 public:
  explicit Failing(Robot& belt) : Generator("Failing"), velocity_(belt, {0.05, 0, 0}) {}
  void start() override { velocity_.start(); }
  void next_state() override {
    if (++steps_ > 20) throw NonFatalError(ErrorCode::force_limit, "the part was not taken");
    velocity_.next_state();
  }

 private:
  ToolVelocity velocity_;
  int steps_ = 0;
};

}  // namespace mrroc::test
