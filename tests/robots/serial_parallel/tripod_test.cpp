#include "robots/serial_parallel/tripod.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "cases.hpp"
#include "legs.hpp"

namespace mrroc::serial_parallel::tripod_test {
namespace {

using Eigen::Vector3d;

constexpr double kInRadians = std::numbers::pi / 180;

double difference(const Placement& a, const Placement& b) {
  return std::max({std::abs(a.swing - b.swing), std::abs(a.tilt - b.tilt), std::abs(a.height - b.height)});
}

TEST(Tripod, LegsReachFromFootToHead) {
  EXPECT_TRUE(rc::check([] {
    const Placement placement = any_placement();
    const auto legs = legs_at(placement);
    const Vector3d lengths = tripod().legs(placement);
    for (int i = 0; i < 3; ++i) {
      RC_ASSERT(std::abs(lengths[i] - legs[static_cast<std::size_t>(i)].along().norm()) < 1e-12);
    }
  }));
}

// constraints of the joints: legs A and C are hinged about the platform's x axis, which stays at right angles to the
// base's y axis; leg B is hinged about the platform's y axis
TEST(Tripod, JointsHoldTheLegsInTheirPlanes) {
  EXPECT_TRUE(rc::check([] {
    const Placement placement = any_placement();
    const auto legs = legs_at(placement);
    const Eigen::Matrix3d platform = tripod().platform(placement).linear();
    RC_ASSERT(std::abs(platform.col(0).y()) < 1e-12);
    RC_ASSERT(std::abs(platform.col(0).dot(legs[0].along())) < 1e-12);
    RC_ASSERT(std::abs(platform.col(0).dot(legs[2].along())) < 1e-12);
    RC_ASSERT(std::abs(platform.col(1).dot(legs[1].along())) < 1e-12);
    RC_ASSERT(std::abs((platform * platform.transpose() - Eigen::Matrix3d::Identity()).norm()) < 1e-12);
  }));
}

// DETC2010-28668, equations (2) to (4) and section 4.5, with hx = hA = hC = l12 = 0 and all working modes +1
TEST(Tripod, LegsAgreeWithThePublishedInverse) {
  EXPECT_TRUE(rc::check([] {
    const Vector3d s(any_between(-0.2, 0.3), any_between(-0.2, 0.2), any_between(0.25, 0.5));
    const double dA = geometry().base.a, dB = geometry().base.b, dC = geometry().base.c;
    const double pA = geometry().platform.a, pB = geometry().platform.b, pC = geometry().platform.c;
    const double t0 = std::hypot(s.x(), s.z());
    const double ca = -s.x() / t0, sa = s.z() / t0;
    const double t6 = (t0 * t0 - dB * s.x()) / t0;
    const double root = std::hypot(t6, s.y());
    const double sb = -s.y() / root, cb = t6 / root;
    const double h = (s.y() * s.y() + t6 * t0) / root - geometry().platform_to_wrist;
    const double t1 = dB * sa - pB, t2 = dB * ca * cb + h, t3 = dB * ca - t2 * cb;
    const Vector3d published(std::hypot(t3 - pA * sb, t2 * sb - pA * cb + dA), std::hypot(t1, t2),
                             std::hypot(t3 - pC * sb, t2 * sb - pC * cb + dC));
    RC_ASSERT((tripod().legs(tripod().placement_of(s)) - published).cwiseAbs().maxCoeff() < 1e-12);
  }));
}

TEST(Tripod, PlacementHasTheWristsCentreAtItsPosition) {
  EXPECT_TRUE(rc::check([] {
    const Placement placement = mrroc::placement_of(any_posture());
    const Vector3d centre = tripod().platform(placement) * Vector3d(0, 0, geometry().platform_to_wrist);
    RC_ASSERT(difference(tripod().placement_of(centre), placement) < 1e-12);
  }));
}

TEST(Tripod, LegRatesAreTheDerivativeOfTheLegs) {
  EXPECT_TRUE(rc::check([] {
    constexpr double kStep = 1e-6;
    const Placement at = any_placement();
    const auto slope = [](const Placement& ahead, const Placement& behind) -> Vector3d {
      return (tripod().legs(ahead) - tripod().legs(behind)) / (2 * kStep);
    };
    Eigen::Matrix3d slopes;
    slopes << slope({at.swing + kStep, at.tilt, at.height}, {at.swing - kStep, at.tilt, at.height}),
        slope({at.swing, at.tilt + kStep, at.height}, {at.swing, at.tilt - kStep, at.height}),
        slope({at.swing, at.tilt, at.height + kStep}, {at.swing, at.tilt, at.height - kStep});
    RC_ASSERT((slopes - tripod().leg_rates(at)).cwiseAbs().maxCoeff() < 1e-8);
  }));
}

// The guarantee of the direct kinematics: a grid over the range of the tripod, ten degrees and 10 mm of leg beyond. In
// its eight steps Newton's method converges from its one start to the placement of the given legs, so that no two
// placements have the same legs. The legs' Jacobian is far from singular.
TEST(Tripod, AssembleFindsEveryPlacementWithinTheLimitsAndBeyond) {
  const Vector3d low = per_axis(&AxisParameters::position_min).head<3>().array() - 0.01;
  const Vector3d high = per_axis(&AxisParameters::position_max).head<3>().array() + 0.01;
  int placements = 0, inside = 0;
  double worst = 0, least_determinant = 1;
  for (double swing = -0.8; swing < 1.25; swing += 0.02) {
    for (double tilt = -0.9; tilt < 0.9; tilt += 0.02) {
      for (double height = 0.18; height < 0.44; height += 0.004) {
        const Placement placement{swing, tilt, height};
        if (!tripod().within_limits(placement, 10 * kInRadians)) continue;
        const Vector3d legs = tripod().legs(placement);
        if ((legs.array() < low.array()).any() || (legs.array() > high.array()).any()) continue;
        Placement found;
        ASSERT_TRUE(tripod().assemble(legs, found)) << swing << " " << tilt << " " << height;
        worst = std::max(worst, difference(found, placement));
        ++placements;
        if (!tripod().within_limits(placement, 0)) continue;
        least_determinant = std::min(least_determinant, std::abs(tripod().leg_rates(placement).determinant()));
        ++inside;
      }
    }
  }
  std::printf("%d placements, %d of them within the limits: worst %.1e rad or m, least determinant %.1e m^2\n",
              placements, inside, worst, least_determinant);
  EXPECT_GT(inside, 20000);
  EXPECT_LT(worst, 1e-11);
  EXPECT_GT(least_determinant, 0.005);
}

TEST(Tripod, LegsThatDoNotCloseAreReportedAndKeepTheLevelPlatform) {
  for (const Vector3d& legs : {Vector3d(0.1, 0.3, 0.5), {0.3, 0.9, 0.3}, {-0.28, 0.295, 0.28}, {0, 0, 0}}) {
    Placement placement{1, 1, 1};
    EXPECT_FALSE(tripod().assemble(legs, placement)) << legs.transpose();
    EXPECT_EQ(difference(placement, {.height = geometry().base.b}), 0);
  }
}

}  // namespace
}  // namespace mrroc::serial_parallel::tripod_test
