#include "drivers/ur/start_sequence.hpp"

#include <cmath>

#include "clock/wall/wait.hpp"
#include "drivers/ur/control_script.hpp"

namespace mrroc::ur {
namespace {

constexpr std::int64_t kBetweenCommands = clock::kSecond / 2;  // ns, before the same command is repeated
constexpr std::int64_t kBetweenQuestions = clock::kSecond / 1000;

}  // namespace

StartSequence::StartSequence(const UrOptions& options, const std::string& script, std::atomic<std::int32_t>& program,
                             std::int32_t first_program, std::int64_t begin)
    : options_(options),
      script_(script),
      program_(program),
      first_program_(first_program),
      deadline_(begin + std::llround(options.start_timeout * 1e9)) {}

bool StartSequence::Repeated::due(std::int64_t now) noexcept {
  if (next_ && now < *next_) return false;
  next_ = now + kBetweenCommands;
  return true;
}

bool StartSequence::is_ready(const RobotState& state) const noexcept {
  const std::int32_t program = program_.load(std::memory_order_relaxed);
  return program != 0 && state.script_program == program && state.script != ScriptState::ended &&
         state.robot_mode == RobotMode::running && state.program_runs();
}

DashboardClient& StartSequence::dashboard() {
  if (!dashboard_) dashboard_.emplace(options_.address, options_.dashboard_port, options_.timeout);
  return *dashboard_;
}

std::optional<UrFault> StartSequence::advance(const RobotState& state, double frequency, std::int64_t now) {
  const UrFault unsafe = safety_fault(state);
  if (std::holds_alternative<ProtectiveStop>(unsafe)) {
    if (is_expired(now))
      return StartFailed{edp::driver_text("the protective stop is not released: %s", refusal_.c_str())};
    if (unlock_.due(now) && !dashboard().unlock_protective_stop()) refusal_ = dashboard().answer();
    return {};
  }
  if (code_of(unsafe) != ErrorCode::none) return unsafe;
  if (is_ready(state)) return UrFault{};
  if (is_expired(now)) {
    const UrFault still = following_fault(state, program_.load(std::memory_order_relaxed));
    return refusal_.empty() ? still : UrFault{StartFailed{edp::DriverText(refusal_)}};
  }
  if (!dashboard().is_in_remote_control()) return NotInRemoteControl{};
  switch (state.robot_mode) {
    case RobotMode::power_off:
      if (!power_.due(now)) break;
      dashboard().close_safety_popup();  // an emergency stop has left it
      if (!dashboard().power_on()) refusal_ = "power on: " + dashboard().answer();
      break;
    case RobotMode::idle:
      if (brakes_.due(now) && !dashboard().release_brakes()) refusal_ = "brake release: " + dashboard().answer();
      break;
    case RobotMode::running:
      if (upload_.due(now)) upload(frequency);
      break;
    default:  // it boots, or powers up
      break;
  }
  return {};
}

void StartSequence::upload(double frequency) {
  const std::int32_t before = program_.load(std::memory_order_relaxed);
  const std::int32_t program = before == 0 ? first_program_ : before + 1;
  program_.store(program, std::memory_order_release);
  if (options_.lockstep) dashboard().stop_program();  // so that the next one that plays is this
  upload_program(control_program(script_, options_, frequency, program), options_);
  if (options_.lockstep) await_program();
}

/// The secondary interface does not confirm a program. In lockstep it must play before the tick ends.
void StartSequence::await_program() {
  const std::int64_t deadline = clock::monotonic_ns() + std::llround(options_.timeout * 1e9);
  while (!dashboard().program_state().starts_with("PLAYING")) {
    if (clock::monotonic_ns() > deadline) throw ConnectionError("the controller does not play the control script");
    clock::pause(kBetweenQuestions);
  }
}

}  // namespace mrroc::ur
