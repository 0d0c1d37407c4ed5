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

/// press, cooperative_transfer, recovering, and press_can and recovering_can, which need an interface can0.
const std::vector<Campaign>& campaigns();

/// By what part of a limit a joint may be faster after this fault: kOvershoot, or kDisobedience where a motor or its
/// encoder does not obey.
double speed_tolerance(const std::string& fault);

}  // namespace mrroc::faults_bench
