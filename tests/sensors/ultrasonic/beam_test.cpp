#include "sensors/ultrasonic/beam.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace mrroc::vsp {
namespace {

constexpr double kRough = std::numbers::pi / 2;

double any_between(double low, double high) { return low + (high - low) * 1e-6 * *rc::gen::inRange(0, 1'000'001); }

double angle_of_ray(std::size_t i, std::size_t rays, double opening) {
  return opening * (static_cast<double>(i) / static_cast<double>(rays - 1) - 0.5);
}

/// Ranges of a fan to an infinite wall at `distance`, with its normal turned by `turn` off the axis.
std::vector<double> wall(std::size_t rays, double opening, double distance, double turn) {
  std::vector<double> ranges;
  for (std::size_t i = 0; i < rays; ++i) ranges.push_back(distance / std::cos(angle_of_ray(i, rays, opening) - turn));
  return ranges;
}

TEST(Beam, EchoIsTheNearestHitOfRoughSurfaces) {
  EXPECT_TRUE(rc::check([] {
    std::vector<double> ranges(*rc::gen::inRange<std::size_t>(1, 17));
    double nearest = INFINITY;
    for (double& range : ranges) {
      range = *rc::gen::inRange(0, 3) == 0 ? kNothingHit : any_between(0, 4);
      if (range >= 0) nearest = std::min(nearest, range);
    }
    RC_ASSERT(nearest_echo(ranges, {0.3, kRough}) == (std::isinf(nearest) ? kNothingHit : nearest));
  }));
}

TEST(Beam, WallFacingTheTransducerIsDetectedWithAnyMaterial) {
  EXPECT_TRUE(rc::check([] {
    const std::size_t rays = *rc::gen::inRange<std::size_t>(3, 17);
    const double opening = any_between(0.05, 1), distance = any_between(0.1, 4);
    const double turn = any_between(-opening / 2, opening / 2);
    const double echo = nearest_echo(wall(rays, opening, distance, turn), {opening, 0.1});
    const double half_step = opening / static_cast<double>(rays - 1) / 2;  // the normal is between two rays
    RC_ASSERT(echo >= distance);
    RC_ASSERT(echo <= distance / std::cos(half_step) * (1 + 1e-12));
  }));
}

TEST(Beam, WallTurnedByMoreThanHalfTheBeamAndTheIncidenceIsNotDetected) {
  EXPECT_TRUE(rc::check([] {
    const std::size_t rays = *rc::gen::inRange<std::size_t>(3, 17);
    const double opening = any_between(0.05, 1), distance = any_between(0.1, 4), incidence = any_between(0.02, 0.5);
    const double away = *rc::gen::element(-1.0, 1.0);
    const Beam beam{opening, incidence};
    const double limit = opening / 2 + incidence;
    RC_ASSERT(nearest_echo(wall(rays, opening, distance, away * (limit + 1e-6)), beam) == kNothingHit);
    // just within the limit: the outermost ray hits it, nearer than all others
    const double seen = nearest_echo(wall(rays, opening, distance, away * (limit - 1e-6)), beam);
    RC_ASSERT(std::abs(seen - distance / std::cos(incidence)) < 1e-5 * seen);
  }));
}

TEST(Beam, EdgeOfATurnedPlateIsDetectedOnlyInsideTheBeam) {
  std::vector<double> ranges = wall(7, 0.26, 1.0, 0.6);
  EXPECT_EQ(nearest_echo(ranges, {0.26, 0.1}), kNothingHit);
  ranges.back() = kNothingHit;  // the plate ends between the last two rays
  EXPECT_EQ(nearest_echo(ranges, {0.26, 0.1}), ranges[5]);
  ranges.back() = 3;  // and there is a wall far behind
  EXPECT_EQ(nearest_echo(ranges, {0.26, 0.1}), ranges[5]);
}

TEST(Beam, ObjectBehindAReflectingMirrorIsDetected) {
  std::vector<double> ranges = wall(7, 0.26, 1.0, 0.6);  // nearest at ray 6
  ranges[0] = 2.6;                                       // beside the mirror, a round object
  ranges[1] = 2.5;
  ranges[2] = 2.6;
  ranges[3] = 2.8;
  EXPECT_EQ(nearest_echo(ranges, {0.26, kRough}), ranges[6]);
  EXPECT_EQ(nearest_echo(ranges, {0.26, 0.1}), 2.5);
}

TEST(Beam, ObjectHitOnlyByTheOutermostRayIsNotAFlatSurface) {
  for (const double behind : {1.2, 2.0, kNothingHit}) {
    const std::vector<double> ranges{1.0, behind, behind, behind, behind};
    EXPECT_EQ(nearest_echo(ranges, {0.26, 0.1}), 1.0) << behind;
    const std::vector<double> mirrored{behind, behind, behind, behind, 1.0};
    EXPECT_EQ(nearest_echo(mirrored, {0.26, 0.1}), 1.0) << behind;
  }
}

}  // namespace
}  // namespace mrroc::vsp
