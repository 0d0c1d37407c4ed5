#pragma once

#include "mrroc/errors.hpp"

namespace mrroc::process {

/// The exit code of a process of a deployment, and of `mrroc run`.
enum class ExitCode : int {
  success = 0,      ///< the task succeeded
  task_failed = 1,  ///< a NonFatalError was not caught by the task
  usage = 2,        ///< wrong arguments or a wrong file: nothing has moved
  hardware = 3,     ///< a HardwareError ended the task
  system = 4,       ///< a SystemError: a process died, a link or the clock was lost
  stopped = 5       ///< the operator stopped the task
};

/// The exit code of an uncaught error of this class.
constexpr ExitCode exit_code(ErrorClass error_class) noexcept {
  switch (error_class) {
    case ErrorClass::none:
      return ExitCode::success;
    case ErrorClass::non_fatal:
      return ExitCode::task_failed;
    case ErrorClass::hardware:
      return ExitCode::hardware;
    case ErrorClass::system:
      return ExitCode::system;
  }
  return ExitCode::system;
}

}  // namespace mrroc::process
