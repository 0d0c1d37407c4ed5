#include "cli/processes/resource_limits.hpp"

#include <sys/resource.h>

#include <algorithm>
#include <filesystem>
#include <string>

#include "clock/clock_memory.hpp"
#include "mrroc/errors.hpp"
#include "process/record/shared_black_box.hpp"
#include "world/world_memory.hpp"

namespace mrroc::cli {

namespace {

// in /proc/PID/fd of a run: a process has 18 files, the runner 15 and four for each process; the rest is for files that
// a task opens
constexpr std::size_t kOfRunner = 24;
constexpr std::size_t kForEachProcess = 4;
constexpr std::size_t kOfProcess = 40;

std::size_t open_files() {
  std::error_code none;
  const std::filesystem::directory_iterator files("/proc/self/fd", none);
  return static_cast<std::size_t>(std::distance(begin(files), end(files)));
}

[[noreturn]] void refuse(const std::string& limit, rlim_t value, std::size_t expected, const std::string& why) {
  throw SystemError(ErrorCode::resources,
                    limit + " is " + std::to_string(value) + ", expected at least " + std::to_string(expected) + why);
}

void check_open_files(std::size_t processes) {
  rlimit limit{};
  if (getrlimit(RLIMIT_NOFILE, &limit) != 0) return;
  const std::size_t needed = std::max(open_files() + kOfRunner + kForEachProcess * processes, kOfProcess);
  if (limit.rlim_cur >= needed) return;
  limit.rlim_cur = std::min<rlim_t>(limit.rlim_max, needed);
  setrlimit(RLIMIT_NOFILE, &limit);
  if (limit.rlim_cur < needed)
    refuse("too many open files: the limit of open files (ulimit -n)", limit.rlim_cur, needed,
           " for " + std::to_string(processes) + " processes");
}

void check_file_size(std::size_t recorded) {
  rlimit limit{};
  const std::size_t needed = std::max(
      {sizeof(clock::ClockMemory), sizeof(world::WorldMemory), process::SharedBlackBox::memory_size(), recorded});
  if (getrlimit(RLIMIT_FSIZE, &limit) == 0 && limit.rlim_cur < needed)
    refuse("File too large: the file size limit (ulimit -f), in bytes,", limit.rlim_cur, needed,
           " for the memory that the processes share");
}

}  // namespace

void check_limits(std::size_t processes, std::size_t recorded) {
  check_open_files(processes);
  check_file_size(recorded);
}

}  // namespace mrroc::cli
