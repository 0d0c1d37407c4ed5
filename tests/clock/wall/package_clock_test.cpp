#include "clock/wall/package_clock.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace mrroc::clock::package_clock_test {
namespace {

constexpr double kPackagePeriod = 0.002;

/// Packages of a controller whose clock is 1000 s behind.
struct Packages {
  Packages() { clock.start(kPackagePeriod); }
  /// The package of period `n`, received `delay` s after its time.
  PackageClock::Verdict take(int n, double delay = 0) {
    const double time = n * kPackagePeriod;
    return clock.take(time, std::llround((1000 + time * (1 + drift) + delay) * 1e9));
  }
  PackageClock clock;
  double drift = 0;
};

TEST(PackageClock, RegularPackagesAreNeitherLostNorLateNorDoubled) {
  Packages packages;
  for (int i = 0; i < 1000; ++i) {
    const auto verdict = packages.take(i, i % 7 * 1e-4);
    EXPECT_EQ(verdict.lost, 0u);
    EXPECT_FALSE(verdict.late || verdict.doubled || verdict.restarted);
  }
}

TEST(PackageClock, CountsLostPackages) {
  Packages packages;
  packages.take(0);
  EXPECT_EQ(packages.take(1).lost, 0u);
  EXPECT_EQ(packages.take(5).lost, 3u);
  EXPECT_EQ(packages.take(6).lost, 0u);
}

TEST(PackageClock, RecognisesDoubledPackages) {
  Packages packages;
  packages.take(0);
  packages.take(1);
  EXPECT_TRUE(packages.take(1).doubled);
  EXPECT_FALSE(packages.take(2).doubled);
}

TEST(PackageClock, APackageIsLateAfterMoreThanAPeriod) {
  Packages packages;
  for (int i = 0; i < 10; ++i) packages.take(i);
  EXPECT_FALSE(packages.take(10, 0.9 * kPackagePeriod).late);
  EXPECT_TRUE(packages.take(11, 1.2 * kPackagePeriod).late);
  EXPECT_FALSE(packages.take(12).late);
}

TEST(PackageClock, ClocksMayDrift) {
  for (const double drift : {1e-4, -1e-4}) {
    Packages packages;
    packages.drift = drift;
    for (int i = 0; i < 200000; ++i) ASSERT_FALSE(packages.take(i).late) << i;
  }
}

TEST(PackageClock, ATimeThatGoesBackIsARestart) {
  Packages packages;
  packages.take(500);
  packages.take(501);
  const auto verdict = packages.take(3);
  EXPECT_TRUE(verdict.restarted);
  EXPECT_EQ(verdict.lost, 0u);
  EXPECT_FALSE(packages.take(4).restarted);
  EXPECT_TRUE(packages.take(100000).restarted);
}

}  // namespace
}  // namespace mrroc::clock::package_clock_test
