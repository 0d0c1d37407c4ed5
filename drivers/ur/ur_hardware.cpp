#include "drivers/ur/ur_hardware.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "clock/wall/monotonic.hpp"
#include "drivers/ur/control_script.hpp"
#include "drivers/ur/lockstep.hpp"
#include "drivers/ur/lockstep_start.hpp"
#include "drivers/ur/terminals.hpp"
#include "drivers/ur/threaded_start.hpp"

namespace mrroc::ur {
namespace {

constexpr int kAxes = 6;
constexpr double kConfirmTime = 2;  // s, for the control script to confirm that it follows, or has stopped

[[noreturn]] void refuse(const std::string& what) {
  throw HardwareError(ErrorCode::drive_not_ready, "UR controller: " + what);
}

const UrOptions& checked(const UrOptions& options, const RobotModel& model) {
  try {
    check(options);
  } catch (const std::invalid_argument& error) {
    refuse(error.what());
  }
  if (model.joint_count() != kAxes)
    refuse("the robot " + model.parameters().type + " has " + std::to_string(model.joint_count()) +
           " axes, expected 6");
  if (!model.parameters().drives.regulate_themselves())
    refuse("the drives of " + model.parameters().type +
           " follow currents, expected regulates = \"itself\" in its parameters");
  return options;
}

/// The control script, whose words have values.
std::string script_of(const UrOptions& options) {
  try {
    std::string script = read_control_script(options);
    control_program(script, options, 1, 0);
    return script;
  } catch (const std::runtime_error& error) {
    refuse(error.what());
  }
}

std::unique_ptr<RobotStart> make_start(const UrOptions& options, RtdeLink& link) {
  if (options.lockstep) return std::make_unique<LockstepStart>(options, link, script_of(options));
  return std::make_unique<ThreadedStart>(options, link, script_of(options));
}

ControlMode mode_of(DriveParameters::Interface interface) noexcept {
  return interface == DriveParameters::Interface::velocity ? ControlMode::velocity : ControlMode::position;
}

JointVector as_joints(const rtde::Vector6d& values) noexcept {
  return Eigen::Map<const Eigen::Matrix<double, kAxes, 1>>(values.data());
}

void copy(const JointVector& from, rtde::Vector6d& to) noexcept {
  for (std::size_t i = 0; i < to.size(); ++i) to[i] = from[static_cast<Eigen::Index>(i)];
}

}  // namespace

UrHardware::UrHardware(const UrOptions& options, const RobotModel& model, double period)
    : options_(checked(options, model)),
      model_(model),
      period_(period),
      drives_(model.parameters().drives),
      mode_(mode_of(drives_.interface)),
      link_(options_, period),
      start_(make_start(options_, link_)) {
  position_ = velocity_ = origin_ = JointVector::Zero(kAxes);
}

UrHardware::~UrHardware() = default;

void UrHardware::open() {
  try {
    link_.open();
  } catch (const ConnectionError& error) {
    throw HardwareError(ErrorCode::hardware_silent, error.what());
  }
}

void UrHardware::enable(bool on) noexcept {
  wanted_ = on;
  if (!on) {
    const bool follows = phase_ == Phase::engaging || phase_ == Phase::following;
    if (phase_ != Phase::failed) phase_ = follows ? Phase::stopping : Phase::off;
    phase_begin_ = now_;
    return;
  }
  phase_ = Phase::starting;
  failure_ = {};
  start_->request();
}

void UrHardware::reset_fault() noexcept {
  wanted_ = false;
  phase_ = Phase::starting;
  failure_ = {};
  start_->request();
}

bool UrHardware::busy() const noexcept {
  return phase_ == Phase::starting || phase_ == Phase::engaging || phase_ == Phase::stopping;
}

bool UrHardware::follows() const noexcept {
  const ScriptState wanted =
      mode_ == ControlMode::position ? ScriptState::following_position : ScriptState::following_velocity;
  return state_.script == wanted && state_.script_program == start_->program();
}

/// The edges of Phase that the robot causes.
void UrHardware::advance() noexcept {
  if (phase_ == Phase::starting && start_->is_running() && !lost_) start_->take(state_);
  if (phase_ == Phase::starting && !start_->is_running()) end_start();
  if (lost_ && busy()) phase_ = Phase::failed;
  const bool expired = static_cast<double>(now_ - phase_begin_) * period_ > kConfirmTime;
  if (phase_ == Phase::engaging) {
    if (follows()) {
      phase_ = Phase::following;
    } else if (expired) {
      phase_ = Phase::failed;
      failure_ = StartFailed{edp::driver_text("the control script does not confirm that it follows")};
    }
  }
  // a stop that is not confirmed is that of the watchdog, or of the controller itself
  const bool runs = code_of(following_fault(state_, start_->program())) == ErrorCode::none;
  if (phase_ == Phase::stopping && (state_.script == ScriptState::holding || !runs || expired)) phase_ = Phase::off;
}

void UrHardware::end_start() noexcept {
  failure_ = start_->failure();
  if (code_of(failure_) != ErrorCode::none) {
    phase_ = Phase::failed;
    return;
  }
  phase_ = wanted_ ? Phase::engaging : Phase::off;
  phase_begin_ = now_;
  held_ = state_.position;
}

/// Lockstep: the package of this tick.
void UrHardware::await(Tick tick) noexcept {
  if (lost_) return;
  const RobotState* const state = link_.await(tick);
  lost_ = state == nullptr;
  if (lost_ || (has_state_ && state->number == state_.number)) return;
  state_ = *state;
  has_state_ = fresh_ = true;
}

/// The packages that have not come; monostate: they have.
UrFault UrHardware::silence(Tick tick) const noexcept {
  if (options_.lockstep) {
    if (!lost_) return {};
    return SilentController{
        0, edp::driver_text("the simulated controller has not sent its package within %lld s of wall time",
                            static_cast<long long>(kLockstepTimeout / clock::kSecond))};
  }
  const auto periods = static_cast<double>(tick - received_) * period_ * link_.frequency();
  const auto age = static_cast<double>(clock::monotonic_ns() - state_.received) * 1e-9 * link_.frequency();
  // a servo that catches up executes ticks faster than packages come
  if (std::min(periods, age) <= options_.missed_max) return {};
  return SilentController{static_cast<std::uint64_t>(age), {}};
}

/// While the robot is made ready, only RobotStart judges its state.
UrFault UrHardware::find_fault(Tick tick) const noexcept {
  if (phase_ == Phase::starting) return {};
  const UrFault silent = silence(tick);
  if (code_of(silent) != ErrorCode::none) return silent;
  const UrFault unsafe = safety_fault(state_);
  if (code_of(unsafe) != ErrorCode::none) return unsafe;
  if (phase_ == Phase::failed) return failure_;
  if (phase_ == Phase::off || phase_ == Phase::stopping) return {};
  return following_fault(state_, start_->program());
}

bool UrHardware::wait(std::int64_t deadline, edp::Beat& beat) noexcept {
  const RobotState* newest = nullptr;
  // the signal of a package may come after a wait that an earlier one has ended, and that has given it already
  do {
    if (!link_.wait(deadline)) return false;
    newest = link_.newest();
  } while (newest == nullptr || (has_state_ && newest->number == state_.number));
  state_ = *newest;
  has_state_ = fresh_ = true;
  beat = {state_.timestamp, state_.received};
  return true;
}

void UrHardware::read(Tick tick, edp::HardwareInput& input) noexcept {
  now_ = tick;
  if (options_.lockstep) await(tick);
  if (!has_state_) {
    input.fault = ErrorCode::hardware_silent;
    return;
  }
  if (std::exchange(fresh_, false)) received_ = tick;
  if (options_.lockstep) input.time = static_cast<double>(received_);
  if (follows())
    input.unseen = static_cast<std::uint32_t>(command_.sequence) - static_cast<std::uint32_t>(state_.script_sequence);
  advance();
  const JointVector joints = as_joints(state_.position);
  JointVector motors(kAxes);
  UrFault fault = find_fault(tick);
  if (model_.joints_to_motors(joints, motors) == ErrorCode::none) input.motors = motors + origin_;
  input.current = as_joints(state_.current);
  for (int axis = 0; axis < kAxes; ++axis)
    if (const double constant = options_.torque_constants[static_cast<std::size_t>(axis)]; constant > 0)
      input.current[axis] *= constant;
  input.synchronised = true;
  if (auto* const silent = std::get_if<SilentController>(&fault); silent != nullptr && !link_.is_up())
    if (const edp::DriverText* const problem = link_.problem()) silent->problem = *problem;
  input.fault = code_of(fault);
  if (input.fault != ErrorCode::none) {
    input.fault_axis = axis_of(fault);
    input.fault_detail = describe(fault);
  }
  input.inputs.digital = as_numbered(state_.digital_inputs, options_.tool_terminals);
  std::copy(state_.analog_inputs.begin(), state_.analog_inputs.end(), input.inputs.analog.begin());
}

void UrHardware::set_points(const JointVector& position, const JointVector& velocity) noexcept {
  position_ = position;
  velocity_ = velocity;
}

void UrHardware::write(Tick tick, const JointVector&) noexcept {
  const auto before =
      options_.lockstep ? static_cast<std::uint32_t>(tick) : static_cast<std::uint32_t>(command_.sequence);
  command_.sequence = static_cast<std::int32_t>(before + 1);
  const bool commands = phase_ == Phase::engaging || phase_ == Phase::following;
  command_.mode = commands ? mode_ : ControlMode::hold;
  if (phase_ == Phase::following) {
    JointVector joints(kAxes);
    const JointVector shafts = position_ - origin_;
    if (model_.motors_to_joints(shafts, joints) == ErrorCode::none) {
      const JointMatrix transmission = model_.transmission(joints);
      JointVector velocity = transmission.partialPivLu().solve(velocity_);
      if (mode_ == ControlMode::velocity) velocity += drives_.position_gain * (joints - as_joints(state_.position));
      copy(joints, command_.position);
      copy(velocity, command_.velocity);
    } else {
      command_.mode = ControlMode::hold;
    }
  } else {
    command_.position = held_;
    command_.velocity = {};
  }
  link_.send(command_);
}

void UrHardware::set_outputs(const ControllerIo& outputs) noexcept {
  command_.outputs = outputs;
  command_.sets_outputs = true;
}

}  // namespace mrroc::ur
