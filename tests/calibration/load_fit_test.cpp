#include "calibration/load_fit.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include "calibration/seeded.hpp"
#include "mrroc/errors.hpp"

namespace mrroc::calibration {
namespace {

/// A load, a zero and a drift, and readings of them.
struct Weighed {
  Load load;
  Wrench zero, drift;
  std::vector<WrenchReading> readings;
};

Weighed weighed(std::uint32_t seed, std::size_t count, double force_noise, double torque_noise) {
  Seeded random(seed);
  Weighed made;
  made.load = {2.55 + random.within(2.45), random.vector(0.1)};
  made.zero << random.vector(2), random.vector(0.1);
  made.drift << random.vector(0.002), random.vector(0.0001);
  for (std::size_t k = 0; k < count; ++k) {
    WrenchReading reading;
    reading.rotation = random.rotation();
    reading.time = 5.0 * static_cast<double>(k);
    const double before = reading.time - 5.0 * static_cast<double>(count - 1);
    reading.wrench = weight_of(made.load, reading.rotation) + made.zero + before * made.drift;
    reading.wrench.head<3>() += random.noise(force_noise);
    reading.wrench.tail<3>() += random.noise(torque_noise);
    made.readings.push_back(reading);
  }
  return made;
}

RC_GTEST_PROP(LoadFit, FindsExactLoadZeroAndDrift, (std::uint32_t seed)) {
  const Weighed made = weighed(seed, 12, 0, 0);
  const LoadFit fit = fit_load(made.readings);
  RC_ASSERT(std::abs(fit.load.mass - made.load.mass) < 1e-9);
  RC_ASSERT((fit.load.centre - made.load.centre).norm() < 1e-9);
  RC_ASSERT((fit.zero - made.zero).norm() < 1e-9);
  RC_ASSERT((fit.drift - made.drift).norm() < 1e-9);
  for (const double residual : fit.force_residuals) RC_ASSERT(residual < 1e-9);
}

// six deviations: one case in a thousand is beyond four
RC_GTEST_PROP(LoadFit, ErrorsOfNoisyReadingsFollowTheDeviations, (std::uint32_t seed)) {
  const Weighed made = weighed(seed, 30, 0.05, 0.002);
  const LoadFit fit = fit_load(made.readings);
  RC_ASSERT(std::abs(fit.load.mass - made.load.mass) < 6 * fit.mass_deviation);
  RC_ASSERT((fit.load.centre - made.load.centre).norm() < 6 * fit.centre_deviation);
  RC_ASSERT((fit.zero - made.zero).head<3>().norm() < 10 * fit.zero_deviation);
}

RC_GTEST_PROP(LoadFit, OrderOfReadingsDoesNotMatter, (std::uint32_t seed)) {
  Weighed made = weighed(seed, 12, 0.05, 0.002);
  const LoadFit fit = fit_load(made.readings);
  std::swap(made.readings[1], made.readings[5]);
  std::swap(made.readings[2], made.readings[9]);
  const LoadFit other = fit_load(made.readings);
  RC_ASSERT(std::abs(fit.load.mass - other.load.mass) < 1e-9);
  RC_ASSERT((fit.load.centre - other.load.centre).norm() < 1e-9);
}

TEST(LoadFit, ReadingsWithoutLoadGiveTheZeroAlone) {
  Weighed made = weighed(7, 12, 0.02, 0.001);
  for (WrenchReading& reading : made.readings) reading.wrench -= weight_of(made.load, reading.rotation);
  const LoadFit fit = fit_load(made.readings);
  EXPECT_EQ(fit.load.mass, 0);
  EXPECT_TRUE(fit.load.centre.isZero());
  EXPECT_LT((fit.zero - made.zero).norm(), 0.1);
}

TEST(LoadFit, RefusesReadingsThatDoNotDefineALoad) {
  Weighed made = weighed(7, 12, 0, 0);
  made.readings[3].wrench[2] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(fit_load(made.readings), NonFatalError);
  made = weighed(7, kLeastReadings - 1, 0, 0);
  EXPECT_THROW(fit_load(made.readings), NonFatalError);
  made = weighed(7, 12, 0, 0);
  for (WrenchReading& reading : made.readings) reading.rotation.setIdentity();
  EXPECT_THROW(fit_load(made.readings), NonFatalError);
  EXPECT_THROW(fit_load(weighed(7, 12, 0, 0).readings, Eigen::Vector3d::Zero()), NonFatalError);
}

}  // namespace
}  // namespace mrroc::calibration
