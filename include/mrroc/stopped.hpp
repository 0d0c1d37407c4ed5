#pragma once

#include <exception>

namespace mrroc {

/// Thrown out of `Move` and `Wait` when the operator stops the task or the process is asked to end. Not an `Error`, so
/// that a task's own error handling does not swallow it; a task lets it pass.
class Stopped : public std::exception {
 public:
  const char* what() const noexcept override { return "stopped by the operator"; }
};

}  // namespace mrroc
