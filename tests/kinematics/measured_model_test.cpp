#include "kinematics/measured_model.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <Eigen/SVD>
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <random>
#include <vector>

#include "allocations.hpp"
#include "kinematics/chain_model.hpp"
#include "kinematics/chains.hpp"
#include "kinematics/measured_chain.hpp"
#include "kinematics/measured_joints.hpp"
#include "kinematics/newton.hpp"
#include "mrroc/errors.hpp"

namespace mrroc::kinematics::measured_model_test {
namespace {

std::shared_ptr<const RobotModel> arm(const SerialChain& chain, std::string name = "nominal") {
  RobotParameters parameters;
  parameters.axes.resize(static_cast<std::size_t>(chain.size()));
  for (AxisParameters& axis : parameters.axes) {
    axis.position_min = -3;
    axis.position_max = 3;
  }
  parameters.home = JointVector::Zero(chain.size());
  return std::make_shared<ChainModel>(std::move(name), parameters, chain, JointVector::Constant(chain.size(), -80));
}

/// Numbers from a seed.
class Numbers {
 public:
  explicit Numbers(unsigned seed) : engine_(seed) {}
  JointVector joints(int count, double size) {
    JointVector joints = JointVector::Zero(count);
    for (double& joint : joints) joint = within(size);
    return joints;
  }
  MeasuredArm measured(int count, double size) {
    const auto axes = static_cast<std::size_t>(count);
    MeasuredArm measured{joints(count, size), std::vector<Twist>(axes), std::vector<Eigen::Vector3d>(axes)};
    for (Twist& link : measured.links)
      for (double& number : link) number = within(size);
    for (Eigen::Vector3d& gear : measured.gears)
      for (double& number : gear) number = within(size);
    return measured;
  }

 private:
  double within(double size) { return std::uniform_real_distribution<double>(-size, size)(engine_); }
  std::mt19937 engine_;
};

std::vector<SerialChain> arms() { return {test::ur5e(), test::puma560(), test::irb140()}; }

RC_GTEST_PROP(MeasuredModel, JointsAreThoseOfTheEncodersPlusTheZeros, ()) {
  Numbers numbers(*rc::gen::arbitrary<unsigned>());
  const RobotModels nominal{arm(test::ur5e())};
  const MeasuredArm measured{numbers.joints(6, 0.1)};
  const RobotModels models = with_measured(nominal, measured);
  const JointVector joints = numbers.joints(6, 3);
  JointVector motors, read, back;
  RC_ASSERT(nominal.front()->joints_to_motors(joints, motors) == ErrorCode::none);
  RC_ASSERT(models.front()->motors_to_joints(motors, read) == ErrorCode::none);
  RC_ASSERT((read - joints - measured.zeros).norm() < 1e-12);
  RC_ASSERT(models.front()->joints_to_motors(read, back) == ErrorCode::none);
  RC_ASSERT((back - motors).norm() < 1e-9);
  RC_ASSERT(models.front()->flange(joints).isApprox(nominal.front()->flange(joints), 0));
}

RC_GTEST_PROP(MeasuredModel, TransmissionIsTheDerivativeOfTheMotors, ()) {
  Numbers numbers(*rc::gen::arbitrary<unsigned>());
  const RobotModels models = with_measured({arm(test::ur5e())}, numbers.measured(6, 0.03));
  const RobotModel& model = *models.front();
  const JointVector joints = numbers.joints(6, 2);
  JointVector motors, back;
  RC_ASSERT(model.joints_to_motors(joints, motors) == ErrorCode::none);
  RC_ASSERT(model.motors_to_joints(motors, back) == ErrorCode::none);
  RC_ASSERT((back - joints).norm() < 1e-12);
  for (int i = 0; i < 6; ++i) {
    const JointVector step = 1e-6 * JointVector::Unit(6, i);
    JointVector above, below;
    RC_ASSERT(model.joints_to_motors(joints + step, above) == ErrorCode::none);
    RC_ASSERT(model.joints_to_motors(joints - step, below) == ErrorCode::none);
    RC_ASSERT(((above - below) / 2e-6 - model.transmission(joints).col(i)).norm() < 1e-6);
  }
}

RC_GTEST_PROP(MeasuredModel, InverseReturnsToThePosture, ()) {
  Numbers numbers(*rc::gen::arbitrary<unsigned>());
  const SerialChain chain = *rc::gen::elementOf(arms());
  const RobotModels models = with_measured({arm(chain)}, numbers.measured(6, 0.002));
  const RobotModel& model = *models.front();
  const JointVector joints = numbers.joints(6, 2.5);
  JointVector found;
  const ErrorCode code = model.inverse(model.flange(joints), joints, found);
  RC_ASSERT(code == ErrorCode::none || code == ErrorCode::singular);
  RC_ASSERT((found - joints).norm() < 1e-12);
  // from beside it
  JointVector beside;
  const JointVector near = joints + numbers.joints(6, 0.05);
  if (model.inverse(model.flange(joints), near, beside) != ErrorCode::none) return;
  RC_ASSERT(displacement(model.flange(beside), model.flange(joints)).norm() < 1e-8);
}

RC_GTEST_PROP(MeasuredModel, JacobianIsTheDerivativeOfTheFlange, ()) {
  Numbers numbers(*rc::gen::arbitrary<unsigned>());
  const SerialChain chain = *rc::gen::elementOf(arms());
  const RobotModels models = with_measured({arm(chain)}, numbers.measured(6, 0.01));
  const JointVector joints = numbers.joints(6, 2);
  const Jacobian jacobian = models.front()->jacobian(joints, Eigen::Vector3d::Zero());
  for (int i = 0; i < 6; ++i) {
    const JointVector step = 1e-6 * JointVector::Unit(6, i);
    const Twist difference =
        displacement(models.front()->flange(joints - step), models.front()->flange(joints + step)) / 2e-6;
    RC_ASSERT((difference - jacobian.col(i)).norm() < 1e-6);
  }
}

/// Counts branches and measures them.
struct Branches final : BranchReceiver {
  void add(const JointVector& joints, bool exact) noexcept override {
    EXPECT_TRUE(exact);
    worst = std::max(worst, displacement(model->flange(joints), pose).norm());
    for (const JointVector& other : postures)
      if ((joints - other).norm() < 1e-6) return;
    postures.push_back(joints);
  }
  bool found() noexcept override { return !postures.empty(); }

  const RobotModel* model = nullptr;
  Pose pose;
  double worst = 0;
  std::vector<JointVector> postures;
};

/// Of those at which two branches do not meet.
TEST(MeasuredModel, HasTheBranchesOfItsType) {
  constexpr double kRegular = 0.1;  // smallest singular value
  Numbers numbers(5);
  int compared = 0;
  for (const SerialChain& chain : arms()) {
    const RobotModels nominal{arm(chain)}, measured = with_measured(nominal, numbers.measured(6, 0.001));
    for (int k = 0; k < 50; ++k) {
      const JointVector joints = numbers.joints(6, 2);
      std::array<Branches, 2> of;
      for (std::size_t i = 0; i < 2; ++i) {
        of[i].model = (i == 0 ? nominal : measured).front().get();
        of[i].pose = of[i].model->flange(joints);
        of[i].model->branches(of[i].pose, joints, of[i]);
        EXPECT_LT(of[i].worst, 1e-8);
      }
      for (const JointVector& posture : of[0].postures) {
        const Eigen::JacobiSVD<Jacobian> svd(chain.jacobian(posture, Eigen::Vector3d::Zero()));
        if (svd.singularValues().minCoeff() < kRegular) continue;
        ++compared;
        EXPECT_TRUE(std::any_of(of[1].postures.begin(), of[1].postures.end(),
                                [&posture](const JointVector& other) {
                                  return std::all_of(other.begin(), other.end(), [&, i = 0](double joint) mutable {
                                    return std::abs(std::remainder(joint - posture[i++], 2 * std::numbers::pi)) < 0.1;
                                  });
                                }))
            << "posture " << k;
      }
    }
  }
  EXPECT_GT(compared, 300);
}

TEST(MeasuredChain, IsThatOfTheModelWithoutLinks) {
  Numbers numbers(3);
  const Pose out(Eigen::Translation3d(0.3, 0.1, 0.2));
  for (const SerialChain& chain :
       {test::ur5e(), test::panda(),
        SerialChain({{Pose::Identity(), Eigen::Vector3d::UnitX(), true}, {out, Eigen::Vector3d::UnitY(), false}},
                    out)}) {
    const auto model = arm(chain);
    const SerialChain same = measured_chain(*model),
                      moved = measured_chain(*model, numbers.measured(chain.size(), 0.01).links);
    const JointVector joints = numbers.joints(chain.size(), 3);
    EXPECT_LT(displacement(same.flange(joints), model->flange(joints)).norm(), 1e-12);
    EXPECT_GT(displacement(moved.flange(joints), model->flange(joints)).norm(), 1e-4);
  }
}

/// The last axis of UR5e at zero lies below the flange: its small motion is that of the flange.
TEST(MeasuredChain, AMovedAxisCarriesWhatFollows) {
  const auto model = arm(test::ur5e());
  const JointVector zero = JointVector::Zero(6);
  for (std::size_t axis = 0; axis < 6; ++axis) {
    std::vector<Twist> links(6, Twist::Zero());
    links[axis] << 0.001, -0.002, 0.003, 0, 0, 0;
    const Pose before = model->flange(zero), after = measured_chain(*model, links).flange(zero);
    EXPECT_LT((after.translation() - before.translation() - links[axis].head<3>()).norm(), 1e-12);
    EXPECT_LT((after.linear() - before.linear()).norm(), 1e-12);
  }
}

TEST(MeasuredModel, RefusesWhatIsNotOfTheRobot) {
  const auto refused = [](const SerialChain& chain, const MeasuredArm& measured) {
    try {
      with_measured({arm(chain)}, measured);
    } catch (const SystemError& error) {
      return error.code() == ErrorCode::configuration;
    }
    return false;
  };
  Numbers numbers(1);
  EXPECT_TRUE(refused(test::ur5e(), {JointVector::Zero(5), {}}));
  EXPECT_TRUE(refused(test::ur5e(), {{}, std::vector<Twist>(5, Twist::Zero())}));
  EXPECT_TRUE(refused(test::panda(), numbers.measured(7, 0.001)));
  EXPECT_FALSE(refused(test::panda(), {JointVector::Constant(7, 0.01), {}}));
}

/// The servo thread and the steps of a Move call these.
TEST(MeasuredModel, NothingIsAllocated) {
  Numbers numbers(1);
  for (const SerialChain& chain : arms()) {
    const RobotModels models = with_measured({arm(chain)}, numbers.measured(6, 0.001));
    const RobotModel& model = *models.front();
    JointVector joints = numbers.joints(6, 1);
    const Pose pose = model.flange(joints);
    JointVector motors = joints;
    {
      const mrroc::test::Counting counting;
      model.inverse(pose, joints, joints);
      model.joints_to_motors(joints, motors);
      model.motors_to_joints(motors, joints);
      joints += model.transmission(joints) * joints;
    }
    EXPECT_EQ(mrroc::test::Counting::counted(), 0U);
  }
}

TEST(MeasuredModel, OtherModelsKeepTheTypesPoses) {
  Numbers numbers(2);
  const auto nominal = arm(test::ur5e()), other = arm(test::ur5e(), "other");
  const MeasuredArm measured = numbers.measured(6, 0.001);
  const RobotModels models = with_measured({nominal, other}, measured);
  const JointVector joints = numbers.joints(6, 1);
  EXPECT_TRUE(models[1]->flange(joints).isApprox(other->flange(joints), 0));
  EXPECT_FALSE(models[0]->flange(joints).isApprox(nominal->flange(joints), 1e-6));
  for (const auto& model : models) {
    JointVector motors, read;
    EXPECT_EQ(other->joints_to_motors(joints, motors), ErrorCode::none);
    EXPECT_EQ(model->motors_to_joints(motors, read), ErrorCode::none);
    EXPECT_LT((read - MeasuredJoints(measured, 6).joints(joints)).norm(), 1e-12);
  }
}

}  // namespace
}  // namespace mrroc::kinematics::measured_model_test
