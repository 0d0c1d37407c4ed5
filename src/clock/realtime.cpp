#include "clock/realtime.hpp"

#include <sched.h>
#include <sys/mman.h>

#include <cerrno>
#include <cstring>

namespace mrroc::clock {

std::string request_realtime(int priority) {
  std::string warning;
  const auto refused = [&warning](const std::string& what, const std::string& grant) {
    warning += (warning.empty() ? "" : "; ") + what + " refused (" + std::strerror(errno) + "): " + grant;
  };
  sched_param parameters{};
  parameters.sched_priority = priority;
  if (::sched_setscheduler(0, SCHED_FIFO, &parameters) != 0)
    refused("SCHED_FIFO " + std::to_string(priority), "grant CAP_SYS_NICE or raise RLIMIT_RTPRIO");
  if (::mlockall(MCL_CURRENT | MCL_FUTURE | MCL_ONFAULT) != 0)
    refused("locked memory", "grant CAP_IPC_LOCK or raise RLIMIT_MEMLOCK");
  return warning;
}

int pin_to_one_cpu() noexcept {
  const int cpu = ::sched_getcpu();
  if (cpu < 0) return -1;
  cpu_set_t set;
  CPU_ZERO(&set);
  CPU_SET(static_cast<unsigned>(cpu), &set);
  return ::sched_setaffinity(0, sizeof(set), &set) == 0 ? cpu : -1;
}

}  // namespace mrroc::clock
