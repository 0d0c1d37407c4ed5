#include "drivers/ur/threaded_start.hpp"

#include <poll.h>
#include <sys/eventfd.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>
#include <utility>

#include "clock/wall/wait.hpp"
#include "drivers/ur/start_sequence.hpp"

namespace mrroc::ur {
namespace {

constexpr std::int64_t kPause = 20'000'000;  // ns

/// Numbers of programs differ between runs, because the registers keep the number of the program before.
std::int32_t first_program() noexcept {
  return static_cast<std::int32_t>(clock::monotonic_ns() / 1'000'000 % 100'000'000);
}

}  // namespace

ThreadedStart::ThreadedStart(const UrOptions& options, RtdeLink& link, std::string script)
    : options_(options), link_(link), script_(std::move(script)) {
  wake_ = ::eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK);
  if (wake_ < 0) throw std::system_error(errno, std::generic_category(), "eventfd");
  thread_ = std::thread([this] { run(); });
}

ThreadedStart::~ThreadedStart() {
  end_.store(true, std::memory_order_release);
  const std::uint64_t one = 1;
  [[maybe_unused]] const ssize_t written = ::write(wake_, &one, sizeof one);
  thread_.join();
  ::close(wake_);
}

void ThreadedStart::request() noexcept {
  requested_.fetch_add(1, std::memory_order_acq_rel);
  const std::uint64_t one = 1;
  [[maybe_unused]] const ssize_t written = ::write(wake_, &one, sizeof one);
}

bool ThreadedStart::is_running() const noexcept {
  return requested_.load(std::memory_order_acquire) != finished_.load(std::memory_order_acquire);
}

const UrFault& ThreadedStart::failure() noexcept {
  static const UrFault kNone;
  const UrFault* const failure = failure_.load();
  return failure == nullptr ? kNone : *failure;
}

void ThreadedStart::run() noexcept {
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
bool ThreadedStart::pause() noexcept {
  clock::pause(kPause);
  return !end_.load(std::memory_order_acquire);
}

UrFault ThreadedStart::start() {
  const std::int64_t begin = clock::monotonic_ns();
  StartSequence sequence(options_, script_, program_, first_program(), begin);
  for (; pause();) {
    const std::int64_t now = clock::monotonic_ns();
    const RobotState* const state = link_.newest_for_start();
    const bool fresh = link_.is_up() && state != nullptr && state->received > begin;
    if (!fresh) {
      if (!sequence.is_expired(now)) continue;
      const edp::DriverText* const problem = link_.problem_for_start();
      return SilentController{0, problem == nullptr ? edp::DriverText("no package") : *problem};
    }
    if (const std::optional<UrFault> result = sequence.advance(*state, link_.program_frequency(), now)) return *result;
  }
  return {};
}

}  // namespace mrroc::ur
