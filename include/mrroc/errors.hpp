#pragma once

#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>

#include "mrroc/types.hpp"

namespace mrroc {

/// The paper's three classes of f_E (section 5). The class determines the reaction and how the task may continue.
enum class ErrorClass : std::uint8_t {
  none = 0,       ///< no error
  non_fatal = 1,  ///< a programmer's or a computation's error: robots hold, the task may catch it and continue
  hardware = 2,   ///< a robot or sensor malfunctions: its robot has stopped, the task may recover it
  system = 3      ///< a process, a link or the clock is lost: every robot stops, the deployment ends
};

/// The cause of an error; `describe()` returns one line for each. Messages carry the number: append only.
enum class ErrorCode : std::uint16_t {
  none = 0,
  invalid_argument = 1,
  not_finite = 2,
  invalid_motion_steps = 3,
  invalid_reply_step = 4,
  joint_limit = 5,
  velocity_limit = 6,
  motor_limit = 7,
  out_of_workspace = 8,
  singular = 9,
  busy = 10,
  not_synchronised = 11,
  sensor_not_ready = 12,
  sensor_out_of_range = 13,
  task_failed = 14,
  force_limit = 15,
  acceleration_limit = 16,
  not_enabled = 17,
  jerk_limit = 18,
  following_error = 100,
  drive_fault = 101,
  sensor_hardware = 102,
  hardware_silent = 103,
  synchronisation_failed = 104,
  over_current = 110,
  limit_switch = 111,
  encoder_fault = 112,
  emergency_stop = 113,
  overspeed = 114,
  axis_stuck = 115,
  bus_off = 116,
  bus_error = 117,
  drive_not_ready = 118,
  heartbeat_lost = 119,
  drive_restarted = 120,
  io_fault = 121,
  process_died = 200,
  process_silent = 201,
  link_lost = 202,
  clock_lost = 203,
  resources = 204,
  configuration = 205,
  simulator = 206
};

/// One line of text for a code, e.g. "the pose is out of the workspace". Any thread; never throws.
std::string_view describe(ErrorCode code) noexcept;

/// "non-fatal error", "hardware error", "system error". Any thread; never throws.
std::string_view describe(ErrorClass error_class) noexcept;

/// Where an error occurred. When not known, `process` and `device` (robot or sensor) are empty, step and tick are 0.
struct ErrorOrigin {
  std::string process;
  std::string device;
  std::uint64_t step = 0;
  Tick tick = 0;
};

class BlackBox;

/// f_E as an exception, thrown by `Move` and `Wait`. `what()` returns "<class> <code text>: <detail> [process arm,
/// robot wrist, step 3, tick 120]".
class Error : public std::runtime_error {
 public:
  ErrorClass error_class() const noexcept { return class_; }
  ErrorCode code() const noexcept { return code_; }
  /// Details of this case: the wrong value and what was expected.
  const std::string& detail() const noexcept { return detail_; }
  const ErrorOrigin& origin() const noexcept { return origin_; }
  const char* what() const noexcept override { return text_.c_str(); }
  /// The last steps of the task until this error ended one of its Moves or Waits (`mrroc/black_box.hpp`); does not
  /// change while the task continues. Null: the error has not passed through a Move or Wait of this process.
  const std::shared_ptr<const BlackBox>& black_box() const noexcept { return black_box_; }

  /// Fills in the empty fields of the origin. Move and Wait do it for every error that passes through them, so that an
  /// error thrown by a generator, a condition or a link also has an origin.
  void complete_origin(const ErrorOrigin& known);
  /// Attaches the black box unless the error already has one, of the innermost instruction. Used by Move and Wait.
  void attach(std::shared_ptr<const BlackBox> black_box) noexcept;

 protected:
  Error(ErrorClass error_class, ErrorCode code, std::string detail, ErrorOrigin origin);

 private:
  ErrorClass class_;
  ErrorCode code_;
  std::string detail_;
  ErrorOrigin origin_;
  std::string text_;
  std::shared_ptr<const BlackBox> black_box_;
};

/// Pose out of workspace, invalid argument, sensor not ready ...: robots hold, the task may catch it and continue.
class NonFatalError : public Error {
 public:
  explicit NonFatalError(ErrorCode code, std::string detail, ErrorOrigin origin = {});
  /// A task's own reason, code `task_failed`.
  explicit NonFatalError(std::string detail);
};

/// Following error, drive fault, dead sensor hardware ...: the robot has stopped on its own, the task may recover it.
class HardwareError : public Error {
 public:
  explicit HardwareError(ErrorCode code, std::string detail, ErrorOrigin origin = {});
};

/// A process died, a link broke, the clock is lost: every robot stops and the deployment ends.
class SystemError : public Error {
 public:
  explicit SystemError(ErrorCode code, std::string detail, ErrorOrigin origin = {});
};

/// Throws the error of class `error_class` (not `none`). Not for the real-time path.
[[noreturn]] void throw_error(ErrorClass error_class, ErrorCode code, std::string detail, ErrorOrigin origin);

}  // namespace mrroc
