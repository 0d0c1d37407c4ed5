#include "mrroc/generators/weight_measurement.hpp"

#include <limits>
#include <random>

#include "language/free_flyer.hpp"
#include "language/property.hpp"
#include "language/random_values.hpp"
#include "mrroc/conditions/elapsed_steps.hpp"
#include "mrroc/move.hpp"

namespace mrroc::weight_measurement_test {
namespace {

using Eigen::Vector3d;
using fakes::check_property;
using fakes::FreeFlyer;
using fakes::pick;
using fakes::random_vector;
using Offset = LoadIdentification::Offset;

constexpr int kCases = 300;
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

Load random_load() { return {0.01 * pick(5, 1000), random_vector(0.2)}; }

Wrench random_offset() {
  Wrench offset;
  offset << random_vector(30), random_vector(3);
  return offset;
}

/// Three orientations that differ by tilts of at least 0.3 rad about two axes, and up to five random ones.
std::vector<Eigen::Matrix3d> random_orientations() {
  const Eigen::Matrix3d first = exp_rotation(random_vector(3));
  std::vector<Eigen::Matrix3d> orientations;
  for (const Vector3d& tilt :
       {Vector3d(0, 0, 0), Vector3d(0.01 * pick(30, 150), 0, 0), Vector3d(0, 0.01 * pick(30, 150), 0)})
    orientations.push_back(exp_rotation(tilt) * first);
  for (int more = pick(0, 5); more > 0; --more) orientations.push_back(exp_rotation(random_vector(3)));
  return orientations;
}

// force by force and point by point, not with the formulas under test
Wrench weight_by_hand(const Load& load, const Eigen::Matrix3d& rotation) {
  const Vector3d pull = load.mass * Vector3d(0, 0, -9.81);  // in the base frame, at the centre
  const Vector3d centre = rotation * load.centre;
  Wrench wrench;
  wrench << rotation.inverse() * pull, rotation.inverse() * centre.cross(pull);
  return wrench;
}

TEST(Load, WeightIsThatOfAMassAtItsCentre) {
  check_property(kCases, [] {
    const Load load = random_load();
    const Eigen::Matrix3d rotation = exp_rotation(random_vector(3));
    RC_ASSERT((weight_of(load, rotation) - weight_by_hand(load, rotation)).norm() < 1e-9);
  });
}

TEST(LoadIdentification, FindsTheLoadWithAnyZero) {
  check_property(kCases, [] {
    const Load load = random_load();
    const Wrench offset = random_offset();
    LoadIdentification readings;
    for (const Eigen::Matrix3d& rotation : random_orientations())
      readings.add(rotation, weight_by_hand(load, rotation) + offset);
    const LoadEstimate found = readings.estimate();
    RC_ASSERT(std::abs(found.load.mass - load.mass) < 1e-9);
    RC_ASSERT((found.load.centre - load.centre).norm() < 1e-9);
    RC_ASSERT((found.offset - offset).norm() < 1e-7);
    RC_ASSERT(found.force_residual < 1e-9 && found.torque_residual < 1e-9);
    RC_ASSERT(found.spread >= LoadIdentification::kLeastSpread);
  });
}

TEST(LoadIdentification, TwoOrientationsAreEnoughWithAKnownZero) {
  check_property(kCases, [] {
    const Load load = random_load();
    const Eigen::Matrix3d first = exp_rotation(random_vector(3));
    LoadIdentification readings(Offset::zero);
    for (const double tilt : {0.0, 0.01 * pick(30, 250)}) {
      const Eigen::Matrix3d rotation = exp_rotation({tilt, 0, 0}) * first;
      readings.add(rotation, weight_by_hand(load, rotation));
    }
    const LoadEstimate found = readings.estimate();
    RC_ASSERT(std::abs(found.load.mass - load.mass) < 1e-9);
    RC_ASSERT((found.load.centre - load.centre).norm() < 1e-9);
    RC_ASSERT(found.offset.isZero(1e-9));
  });
}

// with a wrong deviation the errors would not be standard normal
TEST(LoadIdentification, DeviationsMatchTheErrors) {
  std::mt19937 random{7};
  std::normal_distribution<double> noise;
  const Load load{1.2, {0.01, -0.02, 0.08}};
  const std::vector<Vector3d> turns{{0, 0, 0}, {0.8, 0, 0}, {0, 0.8, 0}, {-0.8, 0.3, 0}, {0.5, -0.7, 1}, {3, 0, 0}};
  double mass_square = 0, centre_square = 0, force_square = 0;
  constexpr int kTrials = 400;
  for (int trial = 0; trial < kTrials; ++trial) {
    LoadIdentification readings;
    for (const Vector3d& turn : turns) {
      Wrench error;
      for (int i = 0; i < 6; ++i) error[i] = (i < 3 ? 0.2 : 0.01) * noise(random);
      readings.add(exp_rotation(turn), weight_by_hand(load, exp_rotation(turn)) + error);
    }
    const LoadEstimate found = readings.estimate();
    mass_square += std::pow((found.load.mass - load.mass) / found.mass_deviation, 2) / kTrials;
    centre_square += (found.load.centre - load.centre).squaredNorm() / std::pow(found.centre_deviation, 2) / kTrials;
    force_square += std::pow(found.force_residual / 0.2, 2) / kTrials;
  }
  EXPECT_NEAR(mass_square, 1, 0.35);
  EXPECT_GT(centre_square, 0.6);  // three directions, the worst of which has the deviation
  EXPECT_LT(centre_square, 3.5);
  EXPECT_NEAR(force_square, 14.0 / 18, 0.1) << "18 values, 4 unknowns";
}

TEST(LoadIdentification, RefusesTooFewOrSimilarOrientations) {
  const Load load{2, {0, 0, 0.1}};
  const auto refused = [&](Offset offset, const std::vector<Vector3d>& turns) {
    LoadIdentification readings(offset);
    for (const Vector3d& turn : turns) readings.add(exp_rotation(turn), weight_of(load, exp_rotation(turn)));
    try {
      readings.estimate();
    } catch (const NonFatalError& error) {
      return error.code() == ErrorCode::invalid_argument;
    }
    return false;
  };
  const Vector3d straight(0, 0, 0);
  EXPECT_TRUE(refused(Offset::unknown, {}));
  EXPECT_TRUE(refused(Offset::unknown, {straight, {1, 0, 0}}));
  EXPECT_TRUE(refused(Offset::unknown, {straight, {1, 0, 0}, straight, {1, 0, 0}})) << "two, twice";
  EXPECT_TRUE(refused(Offset::unknown, {straight, {0, 0, 1}, {0, 0, 2}, {0, 0, 3}})) << "turned about gravity";
  EXPECT_TRUE(refused(Offset::unknown, {straight, {0.05, 0, 0}, {0, 0.05, 0}})) << "3 degrees";
  EXPECT_TRUE(refused(Offset::zero, {straight}));
  EXPECT_TRUE(refused(Offset::zero, {straight, {0, 0, 1}}));
  EXPECT_FALSE(refused(Offset::unknown, {straight, {1, 0, 0}, {0, 1, 0}}));
  EXPECT_FALSE(refused(Offset::zero, {straight, {1, 0, 0}}));
}

TEST(LoadIdentification, ZeroMassHasNoCentre) {
  LoadIdentification readings;
  for (const Vector3d& turn : {Vector3d(0, 0, 0), Vector3d(1, 0, 0), Vector3d(0, 1, 0), Vector3d(0, 0, 1)}) {
    Wrench noise = Wrench::Zero();
    noise[0] = 0.01 * turn.x() - 0.02 * turn.z();
    readings.add(exp_rotation(turn), noise);
  }
  const LoadEstimate found = readings.estimate();
  EXPECT_LT(std::abs(found.load.mass), 3 * found.mass_deviation);
  EXPECT_TRUE(std::isnan(found.load.centre.x()));
  EXPECT_TRUE(std::isinf(found.centre_deviation));
}

TEST(LoadIdentification, RefusesInvalidReadings) {
  EXPECT_THROW(LoadIdentification(Offset::unknown, Vector3d::Zero()), NonFatalError);
  EXPECT_THROW(LoadIdentification(Offset::unknown, Vector3d(0, kNan, 0)), NonFatalError);
  LoadIdentification readings;
  EXPECT_THROW(readings.add(Eigen::Matrix3d::Constant(kNan), Wrench::Zero()), NonFatalError);
  EXPECT_THROW(readings.add(Eigen::Matrix3d::Identity(), Wrench::Constant(kNan)), NonFatalError);
}

/// Joints of the FreeFlyer: position, and rotation vector.
JointVector turned_to(const Vector3d& turn) {
  JointVector joints(6);
  joints << 0.1, -0.2, 0.3, turn;
  return joints;
}

const std::vector<JointVector> kPostures{turned_to({0, 0, 0}), turned_to({0.9, 0, 0}), turned_to({0, -0.8, 0.2})};

TEST(WeightMeasurement, VisitsEveryPostureAndFindsTheLoad) {
  check_property(60, [] {
    FreeFlyer task(Pose::Identity(), static_cast<std::uint16_t>(pick(1, 40)));
    const Load load = random_load();
    const Wrench offset = random_offset();
    Pose before = Pose::Identity();
    task.felt = [&](const Pose& pose) {
      // in motion and just after it, the sensor has other readings
      const bool moved = !pose.isApprox(before, 0);
      before = pose;
      return Wrench{weight_by_hand(load, pose.linear()) + offset + (moved ? Wrench::Constant(20) : Wrench::Zero())};
    };
    WeightMeasurement scale(*task.arm, kPostures, {.speed = 0.01 * pick(10, 100)});
    const Outcome end = Move({*task.arm}, {}, scale);
    RC_ASSERT(end.ending == Ending::generator);
    const LoadEstimate found = scale.estimate();
    RC_ASSERT(std::abs(found.load.mass - load.mass) < 1e-9);
    RC_ASSERT((found.load.centre - load.centre).norm() < 1e-9);
    RC_ASSERT((found.offset - offset).norm() < 1e-7);
    // each posture, and a rest of 1.2 s there
    const double step = task.arm->step_duration();
    for (const JointVector& posture : kPostures) {
      double rest = 0;
      for (const RobotCommand& command : task.commands)
        if (command.kind == CommandKind::hold) rest += step;
      bool reached = false;
      for (const RobotCommand& command : task.commands)
        reached = reached || (command.joints.size() == 6 && command.joints.isApprox(posture, 1e-12));
      RC_ASSERT(reached);
      RC_ASSERT(rest >= 3 * 1.2 - 1e-9);
    }
  });
}

TEST(WeightMeasurement, ContinuesAfterAPauseAndRestartsWhenUsedAgain) {
  FreeFlyer task(Pose::Identity());
  const Load load{1.5, {0.01, 0.02, 0.03}};
  task.felt = [&](const Pose& pose) { return weight_by_hand(load, pose.linear()); };
  task.requests.assign(150, OperatorRequest::none);
  for (int i = 0; i < 30; ++i) task.requests.push_back(OperatorRequest::pause);
  WeightMeasurement scale(*task.arm, kPostures);
  for (int round = 0; round < 2; ++round) {
    EXPECT_EQ(Move({*task.arm}, {}, scale).ending, Ending::generator);
    EXPECT_NEAR(scale.estimate().load.mass, 1.5, 1e-9);
  }
  EXPECT_THROW(WeightMeasurement(*task.arm, kPostures).estimate(), NonFatalError) << "nothing has been measured";
}

TEST(WeightMeasurement, PauseRepeatsNoReading) {
  FreeFlyer task(Pose::Identity());
  task.felt = [&](const Pose& pose) { return weight_by_hand({1, {0, 0, 0}}, pose.linear()); };
  WeightMeasurement scale(*task.arm, {kPostures[0], kPostures[1]});
  task.requests.assign(100, OperatorRequest::none);
  task.requests.push_back(OperatorRequest::pause);
  Move({*task.arm}, {}, scale);
  EXPECT_THROW(scale.estimate(), NonFatalError) << "repeated orientations count once";
}

TEST(WeightMeasurement, RefusesInvalidPostures) {
  FreeFlyer task(Pose::Identity());
  const auto make = [&](std::vector<JointVector> postures, const Weighing& weighing = {}) {
    WeightMeasurement{*task.arm, std::move(postures), weighing};
  };
  EXPECT_NO_THROW(make(kPostures));
  EXPECT_THROW(make({}), NonFatalError);
  EXPECT_THROW(make({JointVector::Zero(5)}), NonFatalError);
  EXPECT_THROW(make({JointVector::Constant(6, kNan)}), NonFatalError);
  EXPECT_THROW(make({JointVector::Constant(6, 2.5)}), NonFatalError);
  for (const double bad : {0.0, 1.1, kNan}) EXPECT_THROW(make(kPostures, {.speed = bad}), NonFatalError);
  for (const double bad : {-0.1, kNan}) {
    EXPECT_THROW(make(kPostures, {.settling = bad}), NonFatalError);
    EXPECT_THROW(make(kPostures, {.measuring = bad}), NonFatalError);
  }
}

}  // namespace
}  // namespace mrroc::weight_measurement_test
