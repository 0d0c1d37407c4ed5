// The dashboard server of a UR controller: its answers to lines of text. Source: Universal Robots, dashboard server.
#include "sim/ur/virtual_controller.hpp"

namespace mrroc::sim::ur {

using mrroc::ur::name_of;

std::string VirtualController::unlock() {
  if (safety_mode_ != SafetyMode::protective_stop) return "Protective stop releasing";
  if (time_ - stopped_at_ < options_.unlock_delay)
    return "Cannot unlock protective stop until 5s after occurrence. Always inspect cause of protective stop before "
           "unlocking";
  safety_mode_ = SafetyMode::normal;
  return "Protective stop releasing";
}

std::string VirtualController::power_on() {
  if (emergency()) return "Cannot power on the robot: emergency stop";
  if (robot_mode_ == RobotMode::power_off && next_mode_ == RobotMode::power_off) {
    next_mode_ = RobotMode::power_on;
    mode_at_ = time_ + kPowerTime;
  }
  return "Powering on";
}

std::string VirtualController::release_brakes() {
  if (safety_mode_ != SafetyMode::normal) return "Brake release refused";
  if (robot_mode_ == RobotMode::idle) {
    next_mode_ = RobotMode::running;
    mode_at_ = time_ + kBrakeTime;
  }
  return "Brake releasing";
}

std::string VirtualController::dashboard(std::string_view line) {
  const auto needs_remote = [this](auto action) -> std::string {
    if (!remote_) return "Command is not allowed due to safety reasons: the robot is not in remote control";
    return action();
  };
  if (line == "PolyscopeVersion") return "URSoftware 5.11.1.108318 (Dec 15 2021)";
  if (line == "get serial number") return "20225500001";
  if (line == "get robot model") return "UR5";
  if (line == "is in remote control") return remote_ ? "true" : "false";
  if (line == "robotmode") return "Robotmode: " + std::string(name_of(robot_mode_));
  if (line == "safetystatus" || line == "safetymode")
    return (line == "safetystatus" ? "Safetystatus: " : "Safetymode: ") + std::string(name_of(safety_mode_));
  if (line == "programState") return program_ ? "PLAYING " + std::string(program_->name()) : "STOPPED <unnamed>";
  if (line == "running") return program_ ? "Program running: true" : "Program running: false";
  if (line == "power on") return needs_remote([this] { return power_on(); });
  if (line == "brake release") return needs_remote([this] { return release_brakes(); });
  if (line == "unlock protective stop") return needs_remote([this] { return unlock(); });
  if (line == "power off")
    return needs_remote([this] {
      power_off();
      return std::string("Powering off");
    });
  if (line == "stop")
    return needs_remote([this] {
      stop_program();
      return std::string("Stopped");
    });
  if (line == "close safety popup") return "closing safety popup";
  if (line == "close popup") return "closing popup";
  if (line.starts_with("popup")) return "showing popup";
  return "could not understand: '" + std::string(line) + "'";
}

}  // namespace mrroc::sim::ur
