#pragma once

#include <time.h>

#include <algorithm>
#include <vector>

namespace mrroc::cli {

/// How long calls compute, us of this thread's processor time: comparable on a busy machine, too. One thread.
class ProcessorTimes {
 public:
  /// Calls `call`, notes its time, and returns its result.
  template <class Call>
  auto measure(const Call& call) {
    const double begin = now();
    auto result = call();
    times_.push_back(now() - begin);
    return result;
  }
  /// Median and largest; 0 before the first call.
  double typical() {
    if (times_.empty()) return 0;
    const auto middle = times_.begin() + static_cast<std::ptrdiff_t>(times_.size() / 2);
    std::nth_element(times_.begin(), middle, times_.end());
    return *middle;
  }
  double worst() const { return times_.empty() ? 0 : *std::max_element(times_.begin(), times_.end()); }

 private:
  static double now() noexcept {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return 1e6 * static_cast<double>(time.tv_sec) + 1e-3 * static_cast<double>(time.tv_nsec);
  }
  std::vector<double> times_;
};

}  // namespace mrroc::cli
