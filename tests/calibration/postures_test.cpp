#include "calibration/postures.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "calibration/load_fit.hpp"
#include "calibration/short_tour.hpp"
#include "calibration/view_postures.hpp"
#include "mrroc/errors.hpp"
#include "robots/irb6/irb6_model.hpp"

namespace mrroc::calibration {
namespace {

class Postures : public testing::Test {
 protected:
  const RobotModels models = load_irb6();
  const RobotModel& model = *models.front();
  const JointVector home = model.parameters().home;

  /// A camera on the flange that sees a marker from home.
  HandEyeFit rough_fit() const {
    HandEyeFit rough;
    rough.camera = Eigen::Translation3d(0.08, 0, 0.06) * Eigen::AngleAxisd(M_PI_2, Eigen::Vector3d::UnitZ());
    rough.marker = model.flange(home) * rough.camera * Pose(Eigen::Translation3d(0.02, 0.01, 0.4)) *
                   Eigen::AngleAxisd(M_PI, Eigen::Vector3d::UnitX());
    return rough;
  }
};

TEST_F(Postures, AreWithinTheLimitsAndTheRegion) {
  const auto postures = gravity_postures(model, {home, 0.6}, 12);
  ASSERT_EQ(postures.size(), 12U);
  EXPECT_EQ(postures.front(), home);
  for (const JointVector& joints : postures) {
    EXPECT_TRUE(within_limits(model, joints)) << joints.transpose();
    EXPECT_TRUE((joints - home).head<3>().isZero());
    EXPECT_LE((joints - home).cwiseAbs().maxCoeff(), 0.6 + 1e-12);
  }
}

TEST_F(Postures, TurnGravityEnoughForALoad) {
  std::vector<WrenchReading> readings;
  const Load load{1.1, {0.004, 0, 0.066}};
  for (const JointVector& joints : gravity_postures(model, {home, 0.6}, 12)) {
    WrenchReading reading;
    reading.rotation = model.flange(joints).linear();
    reading.wrench = weight_of(load, reading.rotation);
    readings.push_back(reading);
    readings.back().time = static_cast<double>(readings.size());
  }
  const LoadFit fit = fit_load(readings);
  EXPECT_GT(fit.spread, 0.3);
  EXPECT_NEAR(fit.load.mass, load.mass, 1e-9);
}

TEST_F(Postures, RefusesARegionWithTooFewOfThem) {
  EXPECT_THROW(gravity_postures(model, {home, 0.6}, 1000), NonFatalError);
  EXPECT_THROW(gravity_postures(model, {home, 0}, 12), NonFatalError);
  EXPECT_THROW(gravity_postures(model, {JointVector::Zero(3), 0.6}, 12), NonFatalError);
}

TEST_F(Postures, LookAtTheMarkerFromManySides) {
  const HandEyeFit rough = rough_fit();
  const auto postures = view_postures(model, rough, home, 20);
  ASSERT_GE(postures.size(), 12U);
  for (const JointVector& joints : postures) {
    EXPECT_TRUE(within_limits(model, joints));
    const Pose seen = (model.flange(joints) * rough.camera).inverse() * rough.marker;
    EXPECT_LT(seen.translation().head<2>().norm(), 0.15 * seen.translation().z());
    EXPECT_GT(seen.linear()(2, 2), -1.0 - 1e-9);
    EXPECT_LT(seen.linear()(2, 2), -std::cos(ViewCap{}.tilt)) << "the marker faces the camera";
  }
}

double time_of(const RobotModel& model, JointVector from, const std::vector<JointVector>& tour) {
  double time = 0;
  for (const JointVector& to : tour) {
    double longest = 0;
    for (Eigen::Index i = 0; i < to.size(); ++i)
      longest = std::max(longest,
                         std::abs(to[i] - from[i]) / model.parameters().axes[static_cast<std::size_t>(i)].velocity_max);
    time += longest;
    from = to;
  }
  return time;
}

RC_GTEST_FIXTURE_PROP(Postures, OfATourAreAllThereAndNoneTakesLonger, ()) {
  auto random = *rc::gen::container<std::vector<std::vector<int>>>(
      rc::gen::container<std::vector<int>>(static_cast<std::size_t>(home.size()), rc::gen::inRange(-500, 500)));
  std::vector<JointVector> postures;
  for (const std::vector<int>& steps : random) {
    JointVector& posture = postures.emplace_back(home);
    for (Eigen::Index i = 0; i < home.size(); ++i) posture[i] += 1e-3 * steps[static_cast<std::size_t>(i)];
  }
  const auto tour = short_tour(model, home, postures);
  const auto less = [](const JointVector& a, const JointVector& b) {
    return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
  };
  auto sorted = tour, expected = postures;
  std::sort(sorted.begin(), sorted.end(), less);
  std::sort(expected.begin(), expected.end(), less);
  RC_ASSERT(sorted == expected);
  RC_ASSERT(short_tour(model, home, postures) == tour);
  // no pair of ways can be exchanged for a shorter one
  const double time = time_of(model, home, tour);
  for (std::size_t first = 0; first < tour.size(); ++first) {
    for (std::size_t last = first + 1; last < tour.size(); ++last) {
      auto other = tour;
      std::reverse(other.begin() + static_cast<std::ptrdiff_t>(first),
                   other.begin() + static_cast<std::ptrdiff_t>(last) + 1);
      RC_ASSERT(time_of(model, home, other) > time - 1e-6);
    }
  }
}

TEST_F(Postures, OfAnArmAreVisitedOnShortWays) {
  const HandEyeFit rough = rough_fit();
  const auto postures = view_postures(model, rough, home, 90);
  const double before = time_of(model, home, postures);
  const double after = time_of(model, home, short_tour(model, home, postures));
  std::printf("%zu postures, %.1f s at full speed before, %.1f s after\n", postures.size(), before, after);
  EXPECT_LT(after, 0.5 * before);
}

}  // namespace
}  // namespace mrroc::calibration
