#pragma once

#include <string>
#include <vector>

namespace mrroc::faults_bench {

/// A task and the faults that are injected into it.
struct Campaign {
  std::string name;
  std::string deployment;  ///< file
  std::vector<std::string> faults;
  bool everywhere = true;  ///< false: it runs only when it is named
  bool recovers = false;   ///< its task must reach its end after every fault
};

/// press, cooperative_transfer, recovering, and press_can and recovering_can, which need an interface can0.
const std::vector<Campaign>& campaigns();

/// Tolerated overspeed of a joint after this fault, as a part of its limit: kOvershoot, or kDisobedience when a motor
/// or its encoder does not obey.
double speed_tolerance(const std::string& fault);

}  // namespace mrroc::faults_bench
