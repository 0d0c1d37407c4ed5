#include "kinematics/measured_joints.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <random>

#include "mrroc/errors.hpp"

namespace mrroc::kinematics::measured_joints_test {
namespace {

class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) {}
  double within(double size) { return std::uniform_real_distribution<double>(-size, size)(engine_); }
  JointVector joints(double size) {
    JointVector joints = JointVector::Zero(6);
    for (double& joint : joints) joint = within(size);
    return joints;
  }
  MeasuredArm measured() {
    MeasuredArm measured{joints(0.2)};
    for (int i = 0; i < 6; ++i) measured.gears.emplace_back(within(0.05), within(0.05), within(0.05));
    return measured;
  }

 private:
  std::mt19937 engine_;
};

RC_GTEST_PROP(MeasuredJoints, EncodersAreTheInverse, ()) {
  Random random(*rc::gen::arbitrary<unsigned>());
  const MeasuredJoints measured(random.measured(), 6);
  const JointVector encoders = random.joints(20);
  RC_ASSERT((measured.encoders(measured.joints(encoders)) - encoders).norm() < 1e-12);
}

RC_GTEST_PROP(MeasuredJoints, SlopesAreTheDerivative, ()) {
  Random random(*rc::gen::arbitrary<unsigned>());
  const MeasuredJoints measured(random.measured(), 6);
  const JointVector encoders = random.joints(3), step = JointVector::Constant(6, 1e-6);
  const JointVector difference = (measured.joints(encoders + step) - measured.joints(encoders - step)) / 2e-6;
  RC_ASSERT((difference - measured.slopes(encoders)).norm() < 1e-8);
}

TEST(MeasuredJoints, AnEncoderAtZeroShowsTheZero) {
  MeasuredArm arm{JointVector::Constant(2, 0.1)};
  EXPECT_EQ(MeasuredJoints(arm, 2).joints(JointVector::Zero(2)), arm.zeros);
  arm.gears = {{0.01, 0, 0}, {0, 0.02, 0.03}};
  EXPECT_EQ(MeasuredJoints(arm, 2).joints(JointVector::Zero(2)), arm.zeros);
  const JointVector found = MeasuredJoints(arm, 2).joints(JointVector::Constant(2, 2));
  EXPECT_DOUBLE_EQ(found[0], 2.1 + 0.01 * 2);
  EXPECT_DOUBLE_EQ(found[1], 2.1 + 0.02 * (std::cos(2) - 1) + 0.03 * std::sin(2));
}

TEST(MeasuredJoints, NumbersOfOtherAxesAreRefused) {
  EXPECT_THROW(MeasuredJoints(MeasuredArm{JointVector::Zero(5)}, 6), SystemError);
  EXPECT_THROW(MeasuredJoints(MeasuredArm{.gears = {Eigen::Vector3d::Zero()}}, 6), SystemError);
  EXPECT_NO_THROW(MeasuredJoints({}, 6));
}

}  // namespace
}  // namespace mrroc::kinematics::measured_joints_test
