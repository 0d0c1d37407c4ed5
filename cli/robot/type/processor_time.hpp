#pragma once

#include <time.h>

#include <cstdint>

namespace mrroc::cli {

/// ns that this thread has computed: comparable on a busy machine, too.
inline std::int64_t processor_ns() noexcept {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return now.tv_sec * std::int64_t{1'000'000'000} + now.tv_nsec;
}

}  // namespace mrroc::cli
