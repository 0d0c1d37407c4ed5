#include "drivers/ur/ur_fault.hpp"

namespace mrroc::ur {
namespace {

using edp::driver_text;
using edp::DriverText;

struct CodeOf {
  ErrorCode operator()(std::monostate) const noexcept { return ErrorCode::none; }
  template <class Kind>
  ErrorCode operator()(const Kind&) const noexcept {
    return Kind::kCode;
  }
};

/// A name and its length, for printf's %.*s.
template <class Mode>
DriverText with_mode(const char* format, Mode mode) noexcept {
  const std::string_view name = name_of(mode);
  return driver_text(format, static_cast<int>(name.size()), name.data());
}

struct Describe {
  DriverText operator()(std::monostate) const noexcept { return {}; }
  DriverText operator()(const SilentController& silent) const noexcept {
    if (!silent.problem.empty()) return silent.problem;
    return driver_text("no package in %llu controller periods", static_cast<unsigned long long>(silent.periods));
  }
  DriverText operator()(ProtectiveStop) const noexcept {
    return driver_text("protective stop; its cause is in the log of the teach pendant");
  }
  DriverText operator()(const EmergencyStop& stop) const noexcept { return with_mode("safety mode %.*s", stop.mode); }
  DriverText operator()(const SafeguardStop& stop) const noexcept {
    return with_mode("safety mode %.*s: close the safeguard", stop.mode);
  }
  DriverText operator()(const SafetyFault& fault) const noexcept {
    return with_mode("safety mode %.*s: restart the safety system on the teach pendant", fault.mode);
  }
  DriverText operator()(const JointFault& fault) const noexcept { return with_mode("joint mode %.*s", fault.mode); }
  DriverText operator()(const PowerOff& off) const noexcept {
    return with_mode("robot mode %.*s, expected RUNNING", off.mode);
  }
  DriverText operator()(NotInRemoteControl) const noexcept {
    return driver_text("not in remote control: select it on the teach pendant");
  }
  DriverText operator()(const ProgramStopped& stopped) const noexcept {
    if (stopped.state == RuntimeState::playing) return driver_text("another program has replaced the control script");
    return with_mode("the control script does not run, program state %.*s", stopped.state);
  }
  DriverText operator()(SetPointsMissing) const noexcept {
    return driver_text("the control script has stopped the robot: it received no set-points");
  }
  DriverText operator()(const StartFailed& failed) const noexcept { return failed.reason; }
};

/// Joints pass through other modes while the robot gets its power.
bool is_joint_fault(JointMode mode) noexcept {
  return mode == JointMode::fault || mode == JointMode::violation || mode == JointMode::not_responding;
}

}  // namespace

ErrorCode code_of(const UrFault& fault) noexcept { return std::visit(CodeOf{}, fault); }

int axis_of(const UrFault& fault) noexcept {
  const auto* const joint = std::get_if<JointFault>(&fault);
  return joint == nullptr ? -1 : joint->axis;
}

DriverText describe(const UrFault& fault) noexcept { return std::visit(Describe{}, fault); }

UrFault safety_fault(const RobotState& state) noexcept {
  switch (state.safety_mode) {
    case SafetyMode::system_emergency_stop:
    case SafetyMode::robot_emergency_stop:
      return EmergencyStop{state.safety_mode};
    case SafetyMode::violation:
    case SafetyMode::fault:
    case SafetyMode::recovery:
    case SafetyMode::validate_joint_id:
      return SafetyFault{state.safety_mode};
    case SafetyMode::protective_stop:
      return ProtectiveStop{};
    case SafetyMode::safeguard_stop:
    case SafetyMode::automatic_safeguard_stop:
    case SafetyMode::three_position_stop:
      return SafeguardStop{state.safety_mode};
    case SafetyMode::normal:
    case SafetyMode::reduced:
    case SafetyMode::undefined:
      break;
  }
  for (int axis = 0; axis < 6; ++axis) {
    const auto mode = static_cast<JointMode>(state.joint_mode[static_cast<std::size_t>(axis)]);
    if (is_joint_fault(mode)) return JointFault{axis, mode};
  }
  return {};
}

UrFault following_fault(const RobotState& state, std::int32_t program) noexcept {
  if (state.robot_mode != RobotMode::running) return PowerOff{state.robot_mode};
  if (state.script_program == program && state.script == ScriptState::ended) return SetPointsMissing{};
  if (!state.program_runs()) return ProgramStopped{state.runtime};
  if (state.script_program != program) return ProgramStopped{RuntimeState::playing};
  return {};
}

}  // namespace mrroc::ur
