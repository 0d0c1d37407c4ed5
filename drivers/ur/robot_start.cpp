#include "drivers/ur/robot_start.hpp"

#include <poll.h>
#include <sys/eventfd.h>
#include <unistd.h>

#include <cerrno>
#include <cmath>
#include <optional>
#include <system_error>
#include <utility>

#include "clock/wall/wait.hpp"
#include "drivers/ur/control_script.hpp"
#include "drivers/ur/dashboard_client.hpp"

namespace mrroc::ur {
namespace {

constexpr std::int64_t kPause = 20'000'000;                    // ns
constexpr std::int64_t kBetweenCommands = clock::kSecond / 2;  // ns, before the same command is repeated

/// Numbers of programs differ between runs, because the registers keep the number of the program before.
std::int32_t first_program() noexcept {
  return static_cast<std::int32_t>(clock::monotonic_ns() / 1'000'000 % 100'000'000);
}

/// A command that is repeated until the robot's state has changed.
class Repeated {
 public:
  bool due() noexcept {
    const std::int64_t now = clock::monotonic_ns();
    if (now < next_) return false;
    next_ = now + kBetweenCommands;
    return true;
  }

 private:
  std::int64_t next_ = 0;
};

}  // namespace

RobotStart::RobotStart(const UrOptions& options, RtdeLink& link, std::string script)
    : options_(options), link_(link), script_(std::move(script)) {
  wake_ = ::eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK);
  if (wake_ < 0) throw std::system_error(errno, std::generic_category(), "eventfd");
  thread_ = std::thread([this] { run(); });
}

RobotStart::~RobotStart() {
  end_.store(true, std::memory_order_release);
  const std::uint64_t one = 1;
  [[maybe_unused]] const ssize_t written = ::write(wake_, &one, sizeof one);
  thread_.join();
  ::close(wake_);
}

void RobotStart::request() noexcept {
  requested_.fetch_add(1, std::memory_order_acq_rel);
  const std::uint64_t one = 1;
  [[maybe_unused]] const ssize_t written = ::write(wake_, &one, sizeof one);
}

bool RobotStart::is_running() const noexcept {
  return requested_.load(std::memory_order_acquire) != finished_.load(std::memory_order_acquire);
}

const UrFault& RobotStart::failure() noexcept {
  static const UrFault kNone;
  const UrFault* const failure = failure_.load();
  return failure == nullptr ? kNone : *failure;
}

void RobotStart::run() noexcept {
  while (!end_.load(std::memory_order_acquire)) {
    const std::uint32_t requested = requested_.load(std::memory_order_acquire);
    if (requested == finished_.load(std::memory_order_relaxed)) {
      pollfd entry{wake_, POLLIN, 0};
      ::poll(&entry, 1, -1);
      std::uint64_t count = 0;
      [[maybe_unused]] const ssize_t taken = ::read(wake_, &count, sizeof count);
      continue;
    }
    UrFault result;
    try {
      result = start();
    } catch (const std::exception& error) {
      result = StartFailed{edp::DriverText(error.what())};
    }
    failure_.store(result);
    finished_.store(requested, std::memory_order_release);
  }
}

/// False: the end.
bool RobotStart::pause() noexcept {
  clock::pause(kPause);
  return !end_.load(std::memory_order_acquire);
}

bool RobotStart::is_ready(const RobotState& state) const noexcept {
  const std::int32_t program = program_.load(std::memory_order_relaxed);
  return program != 0 && state.script_program == program && state.script != ScriptState::ended &&
         state.robot_mode == RobotMode::running && state.program_runs();
}

UrFault RobotStart::start() {
  const std::int64_t begin = clock::monotonic_ns();
  const std::int64_t deadline = begin + std::llround(options_.start_timeout * 1e9);
  std::optional<DashboardClient> dashboard;
  const auto ask = [&]() -> DashboardClient& {
    if (!dashboard) dashboard.emplace(options_.address, options_.dashboard_port, options_.timeout);
    return *dashboard;
  };
  Repeated unlock, power, brakes, upload;
  std::string last;  // refusal of the dashboard
  for (; pause();) {
    const bool expired = clock::monotonic_ns() > deadline;
    const RobotState* const state = link_.newest_for_start();
    const bool fresh = link_.is_up() && state != nullptr && state->received > begin;
    if (!fresh) {
      if (!expired) continue;
      const edp::DriverText* const problem = link_.problem_for_start();
      return SilentController{0, problem == nullptr ? edp::DriverText("no package") : *problem};
    }
    const UrFault unsafe = safety_fault(*state);
    if (std::holds_alternative<ProtectiveStop>(unsafe)) {
      if (expired) return StartFailed{edp::driver_text("the protective stop is not released: %s", last.c_str())};
      if (unlock.due() && !ask().unlock_protective_stop()) last = ask().answer();
      continue;
    }
    if (code_of(unsafe) != ErrorCode::none) return unsafe;
    if (is_ready(*state)) return {};
    if (expired) {
      const UrFault still = following_fault(*state, program_.load(std::memory_order_relaxed));
      return last.empty() ? still : UrFault{StartFailed{edp::DriverText(last)}};
    }
    if (!ask().is_in_remote_control()) return NotInRemoteControl{};
    switch (state->robot_mode) {
      case RobotMode::power_off:
        if (!power.due()) break;
        ask().close_safety_popup();  // an emergency stop has left it
        if (!ask().power_on()) last = "power on: " + ask().answer();
        break;
      case RobotMode::idle:
        if (brakes.due() && !ask().release_brakes()) last = "brake release: " + ask().answer();
        break;
      case RobotMode::running: {
        if (!upload.due()) break;
        const std::int32_t before = program_.load(std::memory_order_relaxed);
        const std::int32_t program = before == 0 ? first_program() : before + 1;
        program_.store(program, std::memory_order_release);
        upload_program(control_program(script_, options_, link_.frequency(), program), options_);
        break;
      }
      default:  // it boots, or powers up
        break;
    }
  }
  return {};
}

}  // namespace mrroc::ur
