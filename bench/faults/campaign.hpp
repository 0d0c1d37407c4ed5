#pragma once

#include <string>
#include <vector>

namespace mrroc::faults_bench {

/// A task, and the faults that are injected into it.
struct Campaign {
  std::string name;
  std::string deployment;  ///< file
  std::vector<std::string> faults;
  bool everywhere = true;  ///< else it is run when it is named only
  bool recovers = false;   ///< its task has to reach its end whatever strikes
};

/// press, cooperative_transfer, recovering, and press_can, which needs an interface can0.
const std::vector<Campaign>& campaigns();

/// By what part of a limit a joint may be faster after this fault. Where everything obeys: 0.05, what a regulator
/// overshoots. Where a motor or its encoder does not: 0.5, as such a joint is stopped at 1.15 of its limit, or when it
/// would come to 1.3 of it, and gains something until then (docs/safety.md).
double speed_tolerance(const std::string& fault);

}  // namespace mrroc::faults_bench
