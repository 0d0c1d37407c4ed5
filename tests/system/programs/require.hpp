#pragma once

#include <string>

#include "mrroc/errors.hpp"

namespace mrroc::test {

/// Ends the task, as failed, with `what` when the condition does not hold.
inline void require(bool holds, const std::string& what) {
  if (!holds) throw NonFatalError(ErrorCode::task_failed, what);
}

}  // namespace mrroc::test
