#include "clock/host_watch.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <array>
#include <string>
#include <string_view>

#include "mrroc/errors.hpp"

namespace mrroc::clock {

HostWatch::HostWatch(const ClockMemory& memory)
    : memory_(memory), process_(static_cast<int>(::syscall(SYS_pidfd_open, memory.host_pid, 0))) {
  if (process_ < 0) throw SystemError(ErrorCode::clock_lost, "clock: its host has died before the start");
  stat_ = ::open(("/proc/" + std::to_string(memory.host_pid) + "/stat").c_str(), O_RDONLY | O_CLOEXEC);
}

HostWatch::~HostWatch() {
  if (stat_ >= 0) ::close(stat_);
  ::close(process_);
}

HostLife HostWatch::poll() noexcept {
  pollfd end{process_, POLLIN, 0};
  if (::poll(&end, 1, 0) != 0) return HostLife::lost;
  // nothing moves before the start, and simulated time stands still with its host
  const bool watches = memory_.mode == Mode::real && memory_.state.load() == State::running;
  return watches && state() == 'T' ? HostLife::stopped : HostLife::alive;  // 't': a debugger holds it
}

/// The state letter of its first thread; 0: not available.
char HostWatch::state() const noexcept {
  std::array<char, 64> text;  // a number, a name of 15 characters in brackets, the letter
  const ssize_t size = ::pread(stat_, text.data(), text.size(), 0);
  if (size <= 0) return 0;
  const std::string_view stat(text.data(), static_cast<std::size_t>(size));
  const std::size_t name = stat.rfind(')');
  return name == std::string_view::npos || name + 2 >= stat.size() ? '\0' : stat[name + 2];
}

}  // namespace mrroc::clock
