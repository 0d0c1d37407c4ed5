#include "language/speed/speed_ramp.hpp"

#include <cmath>

#include "language/property.hpp"
#include "language/random_values.hpp"

namespace mrroc::speed_ramp_test {
namespace {

using fakes::pick;

constexpr RampBounds kBounds{1, 4};

TEST(SpeedRamp, ReachesEverySpeedMonotonicallyWithinItsBounds) {
  fakes::check_property(300, [] {
    TimeScale scale{0.01 * pick(1, 100), 0};
    const double wanted = 0.01 * pick(0, 100), from = scale.factor;
    const double longest = 0.002 * pick(1, 25);
    double time = 0;
    while (scale.factor != wanted || scale.rate != 0) {
      const double h = longest * 0.01 * pick(50, 150);
      const TimeScale next = ramp(scale, wanted, h, kBounds, 1);
      RC_ASSERT(std::abs(next.rate) <= kBounds.rate);
      RC_ASSERT(std::abs(next.rate - scale.rate) <= kBounds.change * h * (1 + 1e-9));
      RC_ASSERT((next.factor - scale.factor) * (wanted - from) >= 0);
      RC_ASSERT((wanted - next.factor) * (wanted - from) >= 0);
      scale = next;
      time += h;
      RC_ASSERT(time < 3);
    }
  });
}

TEST(SpeedRamp, ReturnsToASpeedThatItHasToPass) {
  fakes::check_property(300, [] {
    TimeScale scale{0.01 * pick(1, 100), 0};
    for (int change = 0; change < 5; ++change) {
      const double wanted = 0.01 * pick(1, 100);
      for (int i = pick(1, 60); i > 0; --i) {
        scale = ramp(scale, wanted, 0.002 * pick(1, 25), kBounds, 1);
        RC_ASSERT(scale.factor >= 0);
        RC_ASSERT(scale.factor <= 1);
      }
    }
    for (int i = 0; i < 1500 && !(scale.factor == 0.5 && scale.rate == 0); ++i)
      scale = ramp(scale, 0.5, 0.01, kBounds, 1);
    RC_ASSERT(scale.factor == 0.5);
    RC_ASSERT(scale.rate == 0);
  });
}

TEST(SpeedRamp, OwnTimeIsTheIntegralOfTheFactor) {
  EXPECT_DOUBLE_EQ(own_time({1, 0}, {1, 0}, 0.02), 0.02);
  EXPECT_DOUBLE_EQ(own_time({0.5, 0}, {0.5, 0}, 0.02), 0.01);
  // of the cubic from 1 to 0.8 with the rates -2 and -3, by Simpson's rule, which is exact for it
  const double h = 0.1, middle = 0.5 * (1 + 0.8) + h / 8 * (-2 + 3);
  EXPECT_NEAR(own_time({1, -2}, {0.8, -3}, h), h / 6 * (1 + 4 * middle + 0.8), 1e-15);
}

}  // namespace
}  // namespace mrroc::speed_ramp_test
