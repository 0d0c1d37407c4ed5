#include "calibration/postures.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "calibration/load_fit.hpp"
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
  HandEyeFit rough;
  rough.camera = Eigen::Translation3d(0.08, 0, 0.06) * Eigen::AngleAxisd(M_PI_2, Eigen::Vector3d::UnitZ());
  rough.marker = model.flange(home) * rough.camera * Pose(Eigen::Translation3d(0.02, 0.01, 0.4)) *
                 Eigen::AngleAxisd(M_PI, Eigen::Vector3d::UnitX());
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

}  // namespace
}  // namespace mrroc::calibration
