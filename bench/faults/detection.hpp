#pragma once

namespace mrroc::faults_bench {

/// Runs press under the real clock, kills or stops each of its processes `seeds` times at a random tick, and prints the
/// wall time from the signal to the runner's message. `load`: number of threads that compute at the same time. Returns
/// false when a fault was not reported within 50 ms.
bool run_detection(int seeds, int load);

}  // namespace mrroc::faults_bench
