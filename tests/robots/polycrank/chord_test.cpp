#include "robots/polycrank/chord.hpp"

#include <gtest/gtest.h>

#include "robots/polycrank/polycrank_cases.hpp"

namespace mrroc::polycrank::chord_test {
namespace {

double any_length() { return any_between(0.05, 0.5) * (*rc::gen::arbitrary<bool>() ? 1 : -1); }

TEST(PolycrankPlanarPair, AnglesMoveTheEndToEveryReachablePointWithTheirBend) {
  EXPECT_TRUE(rc::check([] {
    const PlanarPair pair(any_length(), any_length());
    const Eigen::Vector2d point = pair.end(any_between(-4, 4), any_between(-4, 4));
    const double bend = *rc::gen::arbitrary<bool>() ? 1 : -1;
    const Eigen::Vector2d angles = pair.angles(point, bend, 0);
    RC_ASSERT((pair.end(angles[0], angles[1]) - point).norm() < 1e-12);
    RC_ASSERT(angles[1] * bend >= 0);
    RC_ASSERT(std::abs(angles[1]) <= M_PI);
  }));
}

TEST(PolycrankPlanarPair, PointsTowardsAPointOutOfReach) {
  const PlanarPair pair(0.3, -0.2);
  const Eigen::Vector2d far = pair.angles({0, 2}, 1, 0);
  EXPECT_LT((pair.end(far[0], far[1]) - Eigen::Vector2d(0, 0.5)).norm(), 1e-12);
}

TEST(PolycrankPlanarPair, EqualCranksFoldOntoTheirAxisWithAnyAngle) {
  const PlanarPair equal(0.15, 0.15);
  ASSERT_TRUE(equal.folds_onto({0, 1e-11}));
  EXPECT_FALSE(equal.folds_onto({0, 1e-9}));
  EXPECT_FALSE(PlanarPair(0.15, 0.16).folds_onto({0, 0}));
  EXPECT_EQ(equal.angles({0, 0}, -1, 0.7), Eigen::Vector2d(0.7, -M_PI));
}

TEST(PolycrankChord, HoldsThePointsOfTheLineThatThePairReaches) {
  EXPECT_TRUE(rc::check([] {
    const PlanarPair pair(any_length(), any_length());
    const double distance = any_between(-1.1, 1.1), centre = any_between(-1, 1), t = any_between(-2, 2);
    const double radius = std::hypot(distance, t - centre);
    const bool reached = radius >= pair.shortest_reach() && radius <= pair.longest_reach();
    const auto line = chord(pair, centre, distance);
    RC_ASSERT((line && line->contains(t)) == reached);
  }));
}

TEST(PolycrankChord, NoPointOfBothIsNearerThanTheNearest) {
  EXPECT_TRUE(rc::check([] {
    const auto any_chord = [] {
      const double inner = any_between(0, 1);
      return Chord{any_between(-1, 1), inner, inner + any_between(0, 1)};
    };
    const Chord one = any_chord(), other = any_chord();
    const double wanted = any_between(-3, 3);
    const auto nearest = nearest_in_both(one, other, wanted);
    if (nearest) RC_ASSERT(one.contains(*nearest) && other.contains(*nearest));
    for (double t = -4; t < 4; t += 0.01) {
      if (!one.contains(t) || !other.contains(t)) continue;
      RC_ASSERT(nearest.has_value());
      RC_ASSERT(std::abs(*nearest - wanted) <= std::abs(t - wanted) + 1e-9);
    }
  }));
}

}  // namespace
}  // namespace mrroc::polycrank::chord_test
