#include "clock/wall/realtime.hpp"

#include <sched.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <cstring>

namespace mrroc::clock {

namespace {

/// With a finite limit that suffices now, later mappings such as the stack of a thread would be refused. So memory is
/// locked only without a limit. A limit of 0 applies to every process without CAP_IPC_LOCK.
bool lock_memory() {
  rlimit limit{};
  if (::getrlimit(RLIMIT_MEMLOCK, &limit) != 0) return false;
  const rlimit before = limit;
  limit.rlim_cur = limit.rlim_max == RLIM_INFINITY ? RLIM_INFINITY : 0;
  if (::setrlimit(RLIMIT_MEMLOCK, &limit) != 0) return false;
  const bool locked = ::mlockall(MCL_CURRENT | MCL_FUTURE | MCL_ONFAULT) == 0;
  const int problem = errno;
  if (!locked || limit.rlim_cur == 0) ::setrlimit(RLIMIT_MEMLOCK, &before);
  errno = problem;
  return locked;
}

}  // namespace

std::string request_realtime(int priority) {
  std::string warning;
  const auto refused = [&warning](const std::string& what, const std::string& grant) {
    warning += (warning.empty() ? "" : "; ") + what + " refused (" + std::strerror(errno) + "): " + grant;
  };
  sched_param parameters{};
  parameters.sched_priority = priority;
  if (::sched_setscheduler(0, SCHED_FIFO, &parameters) != 0)
    refused("SCHED_FIFO " + std::to_string(priority), "grant CAP_SYS_NICE or raise RLIMIT_RTPRIO");
  if (!lock_memory()) refused("locked memory", "grant CAP_IPC_LOCK or an unlimited RLIMIT_MEMLOCK");
  return warning;
}

std::string refused_realtime(int priority) {
  std::string refused;
  sched_param before{}, parameters{};
  const int policy = ::sched_getscheduler(0);
  ::sched_getparam(0, &before);
  parameters.sched_priority = priority;
  if (::sched_setscheduler(0, SCHED_FIFO, &parameters) != 0)
    refused = "real-time priority";
  else
    ::sched_setscheduler(0, policy, &before);
  if (!lock_memory())
    refused += refused.empty() ? "locked memory" : " and locked memory";
  else
    ::munlockall();
  return refused;
}

void take_short_slice() noexcept {
  // glibc before 2.41 has neither the call nor its structure: sched_setattr(2)
  struct {
    std::uint32_t size = sizeof(*this);
    std::uint32_t policy = SCHED_OTHER;
    std::uint64_t flags = 0;
    std::int32_t nice = 0;
    std::uint32_t priority = 0;
    std::uint64_t runtime = 100'000;  // ns
    std::uint64_t deadline = 0;
    std::uint64_t period = 0;
  } attributes;
  attributes.nice = ::getpriority(PRIO_PROCESS, 0);
  ::syscall(SYS_sched_setattr, 0, &attributes, 0);
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
