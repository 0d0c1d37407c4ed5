#include "edp/servo/robot_grid.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace mrroc::edp::robot_grid_test {
namespace {

constexpr double kGridPeriod = 0.002;
constexpr std::int64_t kEpoch = 5'000'000'000;
constexpr double kOrigin = 777;  // of the controller's clock, s

/// A controller whose second lasts `rate` of ours, begun `phase` periods after the epoch.
struct Peer {
  double rate = 1, phase = 0;
  double place(double n) const { return phase + n * rate; }
  Beat beat(double n, double delay = 0) const {  // delay: periods
    return {kOrigin + n * kGridPeriod, kEpoch + std::llround((place(n) + delay) * kGridPeriod * 1e9)};
  }
};

TEST(RobotGrid, PlacesAPunctualControllerWhereItIs) {
  const Peer peer{1, 0.3};
  RobotGrid grid(kEpoch, kGridPeriod);
  for (int n = 0; n < 100; ++n) EXPECT_NEAR(grid.place(peer.beat(n)), n + 0.3, 1e-4) << n;
}

RC_GTEST_PROP(RobotGrid, AdvancesEvenlyAndStaysWithTheController, ()) {
  const double error = *rc::gen::inRange(-250, 251) * 1e-6;
  const double loss = *rc::gen::inRange(0, 20) / 100.0;
  const double jitter = *rc::gen::inRange(0, 300) / 100.0;  // periods
  std::mt19937 random(*rc::gen::arbitrary<unsigned>());
  const Peer peer{1 + error, *rc::gen::inRange(0, 1000) / 1000.0};
  RobotGrid grid(kEpoch, kGridPeriod);
  std::uniform_real_distribution<double> uniform(0, 1);
  double last = 0;
  int before = 0;
  for (int n = 0; n < 60000; ++n) {
    if (n > 0 && uniform(random) < loss) continue;
    // most packages are quick, some wait for others
    const double delay = uniform(random) < 0.1 ? 0 : jitter * uniform(random);
    const double place = grid.place(peer.beat(n, delay));
    if (n > 5000) {
      const int steps = n - before;
      RC_ASSERT(std::abs(place - last - steps) <= RobotGrid::kSlew * steps + 1e-6);
      RC_ASSERT(std::abs(place - peer.place(n)) < 0.1);
    }
    last = place;
    before = n;
  }
}

TEST(RobotGrid, ALateFirstPackageIsCorrectedAtOnce) {
  const Peer peer;
  RobotGrid grid(kEpoch, kGridPeriod);
  EXPECT_NEAR(grid.place(peer.beat(0, 20)), 20, 1e-4);
  EXPECT_NEAR(grid.place(peer.beat(1)), 1, 1e-4);
}

TEST(RobotGrid, LatePackagesDoNotDelayIt) {
  const Peer peer;
  RobotGrid grid(kEpoch, kGridPeriod);
  for (int n = 0; n < 100; ++n) grid.place(peer.beat(n));
  for (int n = 100; n < 200; ++n) EXPECT_NEAR(grid.place(peer.beat(n, 9)), n, 0.05) << n;
}

TEST(RobotGrid, AControllerThatRestartsHasAnotherClock) {
  const Peer peer;
  RobotGrid grid(kEpoch, kGridPeriod);
  for (int n = 0; n < 100; ++n) grid.place(peer.beat(n));
  // its time goes back, then far forward
  EXPECT_NEAR(grid.place({3, kEpoch + std::llround(500 * kGridPeriod * 1e9)}), 500, 1e-4);
  EXPECT_NEAR(grid.place({3 + 2 * RobotGrid::kRestart, kEpoch + std::llround(900 * kGridPeriod * 1e9)}), 900, 1e-4);
}

}  // namespace
}  // namespace mrroc::edp::robot_grid_test
