#pragma once

#include <cstdint>

#include "mrroc/condition.hpp"

namespace mrroc {

/// `steps` steps of the instruction have been executed.
class ElapsedSteps : public Condition {
 public:
  explicit ElapsedSteps(std::uint64_t steps);

  void start() override { executed_ = 0; }

 protected:
  bool holds() override { return executed_++ >= steps_; }

 private:
  std::uint64_t steps_;
  std::uint64_t executed_ = 0;  // evaluations so far: one at i0, then one per step
};

}  // namespace mrroc
