#include "vsp/noise.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace mrroc::vsp::noise_test {
namespace {

constexpr int kSamples = 100000;

std::vector<double> normals(const Noise& noise, std::uint32_t stream) {
  std::vector<double> values;
  for (Tick tick = 0; tick < kSamples; ++tick) values.push_back(noise.normal(tick, stream));
  return values;
}

/// Mean of a_k b_k: the correlation of two series of deviation 1.
double correlation(const std::vector<double>& a, const std::vector<double>& b, std::size_t lag) {
  double sum = 0;
  for (std::size_t k = 0; k + lag < a.size(); ++k) sum += a[k] * b[k + lag];
  return sum / kSamples;
}

TEST(Noise, IsAFunctionOfNameTickAndStream) {
  const Noise a("wrist");
  const double first = a.normal(77, 2);
  const double uniform = a.uniform(77, 2);
  normals(a, 0);  // earlier calls have no effect
  EXPECT_EQ(a.normal(77, 2), first);
  EXPECT_EQ(Noise("wrist").normal(77, 2), first);
  EXPECT_EQ(Noise("wrist").uniform(77, 2), uniform);
  EXPECT_NE(Noise("wrist2").normal(77, 2), first);
  EXPECT_NE(a.normal(78, 2), first);
  EXPECT_NE(a.normal(77, 3), first);
}

TEST(Noise, NormalHasMeanZeroDeviationOneAndNormalTails) {
  double sum = 0, squares = 0;
  int beyond_two = 0;
  for (const double x : normals(Noise("wrist"), 0)) {
    ASSERT_TRUE(std::isfinite(x));
    sum += x;
    squares += x * x;
    if (std::abs(x) > 2) ++beyond_two;
  }
  EXPECT_NEAR(sum / kSamples, 0, 0.01);
  EXPECT_NEAR(std::sqrt(squares / kSamples), 1, 0.01);
  EXPECT_NEAR(beyond_two / double{kSamples}, 0.0455, 0.003);
}

TEST(Noise, UniformFillsTheUnitInterval) {
  const Noise noise("gate");
  std::vector<int> bins(10);
  for (Tick tick = 0; tick < kSamples; ++tick) {
    const double x = noise.uniform(tick, 0);
    ASSERT_GE(x, 0);
    ASSERT_LT(x, 1);
    ++bins[static_cast<std::size_t>(x * 10)];
  }
  for (const int count : bins) EXPECT_NEAR(count, kSamples / 10, 400);
}

TEST(Noise, StreamsNamesAndTicksAreUncorrelated) {
  const Noise noise("wrist");
  const std::vector<double> stream = normals(noise, 0);
  EXPECT_NEAR(correlation(stream, stream, 1), 0, 0.015);
  EXPECT_NEAR(correlation(stream, normals(noise, 1), 0), 0, 0.015);
  EXPECT_NEAR(correlation(stream, normals(Noise("wrist2"), 0), 0), 0, 0.015);
}

}  // namespace
}  // namespace mrroc::vsp::noise_test
