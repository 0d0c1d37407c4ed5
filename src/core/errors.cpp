#include "mrroc/errors.hpp"

#include <utility>

#include "core/error_text.hpp"

namespace mrroc {

std::string_view describe(ErrorCode code) noexcept {
  switch (code) {
    case ErrorCode::none:
      return "no error";
    case ErrorCode::invalid_argument:
      return "invalid argument";
    case ErrorCode::not_finite:
      return "a value is not finite";
    case ErrorCode::invalid_motion_steps:
      return "motion_steps N is out of range";
    case ErrorCode::invalid_reply_step:
      return "reply_step v is out of range";
    case ErrorCode::joint_limit:
      return "a joint position limit would be passed";
    case ErrorCode::velocity_limit:
      return "a joint velocity limit would be passed";
    case ErrorCode::motor_limit:
      return "a motor position limit would be passed";
    case ErrorCode::out_of_workspace:
      return "the pose is out of the workspace";
    case ErrorCode::singular:
      return "the pose is singular";
    case ErrorCode::busy:
      return "the receiver is busy";
    case ErrorCode::not_synchronised:
      return "the robot is not synchronised";
    case ErrorCode::sensor_not_ready:
      return "the sensor has no reading yet";
    case ErrorCode::sensor_out_of_range:
      return "the sensor reading is out of range";
    case ErrorCode::task_failed:
      return "the task failed";
    case ErrorCode::force_limit:
      return "a force limit is passed";
    case ErrorCode::jerk_limit:
      return "a joint would exceed its jerk limit";
    case ErrorCode::acceleration_limit:
      return "a joint acceleration limit would be passed";
    case ErrorCode::not_enabled:
      return "the drives are not enabled";
    case ErrorCode::following_error:
      return "the following error is too large";
    case ErrorCode::drive_fault:
      return "a drive reports a fault";
    case ErrorCode::sensor_hardware:
      return "the sensor hardware malfunctions";
    case ErrorCode::hardware_silent:
      return "the hardware does not answer";
    case ErrorCode::synchronisation_failed:
      return "the synchronisation switch or the zero pulse was not found";
    case ErrorCode::over_current:
      return "a drive's current has been at its limit for too long";
    case ErrorCode::limit_switch:
      return "a limit switch stops the axis";
    case ErrorCode::encoder_fault:
      return "an encoder's reading cannot be true";
    case ErrorCode::overspeed:
      return "a joint is faster than its limit";
    case ErrorCode::axis_stuck:
      return "an axis does not move though it is commanded to";
    case ErrorCode::bus_off:
      return "the CAN controller has left the bus";
    case ErrorCode::bus_error:
      return "the CAN bus fails";
    case ErrorCode::drive_not_ready:
      return "a drive is not ready for operation";
    case ErrorCode::heartbeat_lost:
      return "a drive's heartbeat is lost";
    case ErrorCode::drive_restarted:
      return "a drive has restarted";
    case ErrorCode::io_fault:
      return "an I/O node fails";
    case ErrorCode::emergency_stop:
      return "the emergency stop is pressed or not reset";
    case ErrorCode::process_died:
      return "a process died";
    case ErrorCode::process_silent:
      return "a process is silent";
    case ErrorCode::link_lost:
      return "a link is lost";
    case ErrorCode::clock_lost:
      return "the clock is lost";
    case ErrorCode::resources:
      return "a system resource is missing";
    case ErrorCode::configuration:
      return "the configuration is wrong";
    case ErrorCode::simulator:
      return "the simulator failed";
  }
  return "unknown error";
}

std::string_view describe(ErrorClass error_class) noexcept {
  switch (error_class) {
    case ErrorClass::none:
      return "no error";
    case ErrorClass::non_fatal:
      return "non-fatal error";
    case ErrorClass::hardware:
      return "hardware error";
    case ErrorClass::system:
      return "system error";
  }
  return "unknown class of error";
}

std::string error_text(ErrorClass error_class, ErrorCode code, const std::string& detail, const ErrorOrigin& origin) {
  std::string text{describe(error_class)};
  text.append(": ").append(describe(code));
  if (!detail.empty()) text.append(": ").append(detail);
  std::string place;
  const auto add = [&place](const std::string& word, const std::string& value) {
    if (!place.empty()) place += ", ";
    place += word + " " + value;
  };
  if (!origin.process.empty()) add("process", origin.process);
  if (!origin.device.empty()) add("device", origin.device);
  if (origin.step != 0) add("step", std::to_string(origin.step));
  if (origin.tick != 0) add("tick", std::to_string(origin.tick));
  if (!place.empty()) text += " [" + place + "]";
  return text;
}

Error::Error(ErrorClass error_class, ErrorCode code, std::string detail, ErrorOrigin origin)
    : std::runtime_error(detail),
      class_(error_class),
      code_(code),
      detail_(std::move(detail)),
      origin_(std::move(origin)),
      text_(error_text(class_, code_, detail_, origin_)) {}

void Error::complete_origin(const ErrorOrigin& known) {
  if (origin_.process.empty()) origin_.process = known.process;
  if (origin_.device.empty()) origin_.device = known.device;
  if (origin_.step == 0) origin_.step = known.step;
  if (origin_.tick == 0) origin_.tick = known.tick;
  text_ = error_text(class_, code_, detail_, origin_);
}

void Error::attach(std::shared_ptr<const BlackBox> black_box) noexcept {
  if (black_box_ == nullptr) black_box_ = std::move(black_box);
}

NonFatalError::NonFatalError(ErrorCode code, std::string detail, ErrorOrigin origin)
    : Error(ErrorClass::non_fatal, code, std::move(detail), std::move(origin)) {}

NonFatalError::NonFatalError(std::string detail)
    : Error(ErrorClass::non_fatal, ErrorCode::task_failed, std::move(detail), {}) {}

HardwareError::HardwareError(ErrorCode code, std::string detail, ErrorOrigin origin)
    : Error(ErrorClass::hardware, code, std::move(detail), std::move(origin)) {}

SystemError::SystemError(ErrorCode code, std::string detail, ErrorOrigin origin)
    : Error(ErrorClass::system, code, std::move(detail), std::move(origin)) {}

void throw_error(ErrorClass error_class, ErrorCode code, std::string detail, ErrorOrigin origin) {
  switch (error_class) {
    case ErrorClass::hardware:
      throw HardwareError(code, std::move(detail), std::move(origin));
    case ErrorClass::system:
      throw SystemError(code, std::move(detail), std::move(origin));
    default:
      throw NonFatalError(code, std::move(detail), std::move(origin));
  }
}

}  // namespace mrroc
