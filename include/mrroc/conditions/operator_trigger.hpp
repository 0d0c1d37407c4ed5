#pragma once

#include "mrroc/condition.hpp"

namespace mrroc {

class Task;

/// The operator has given a trigger since the instruction began.
class OperatorTrigger : public Condition {
 public:
  explicit OperatorTrigger(Task& task);

  /// Discards triggers given before the instruction.
  void start() override;

 protected:
  bool holds() override;

 private:
  Task* task_;
  bool given_ = false;
};

}  // namespace mrroc
