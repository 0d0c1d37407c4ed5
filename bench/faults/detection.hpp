#pragma once

namespace mrroc::faults_bench {

/// Runs press under the real clock, kills or halts each of its processes `seeds` times at a random tick, and prints the
/// wall time from the signal to the runner's notice. `load`: threads that compute beside it all the while. False: one
/// was not noticed within 50 ms.
bool run_detection(int seeds, int load);

}  // namespace mrroc::faults_bench
