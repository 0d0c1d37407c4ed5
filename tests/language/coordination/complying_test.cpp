// Compliance about the trajectory of the MP.
#include "mrroc/generators/complying.hpp"

#include "language/coordination/fake_mp.hpp"
#include "language/fakes.hpp"
#include "language/property.hpp"
#include "mrroc/move.hpp"

namespace mrroc::fakes::complying_test {
namespace {

/// One arm, whose MP wishes it at rest at a pose, beside a spring that is relaxed at `relaxed` along its z axis.
struct Cell {
  explicit Cell(const Compliance& compliance, double stiffness, double relaxed)
      : arm(task.robot("arm")), superior(mp), complying(superior, *arm, compliance) {
    FakeRobotLink& fake = task.robot_fake("arm");
    mp.items = {item(CommandKind::query)};
    mp.make = [this, &fake, stiffness, relaxed](const std::vector<RobotState>&) {
      const double z = complying.displacement()[2];
      fake.state.wrench = Wrench::Zero();
      fake.state.wrench[2] = -stiffness * (z - relaxed);
      RobotCommand command;
      command.kind = CommandKind::pose;
      command.pose.translation() = Eigen::Vector3d(0.1, 0.2, 0.3);
      return command;
    };
  }
  ErrorCode run(std::uint64_t steps) {
    complying.until(When{"over", [this, steps] { return mp.replies.size() > steps; }});
    try {
      Move({*arm}, {}, complying);
    } catch (const Error& error) {
      return error.code();
    }
    return ErrorCode::none;
  }

  FakeTask task;
  FakeMp mp;
  std::unique_ptr<Robot> arm;
  Superior superior;
  Complying complying;
};

TEST(Complying, GivesWayUntilTheSpringIsRelaxed) {
  Compliance compliance;
  compliance.admittance.setConstant(2e-4);
  Cell cell(compliance, 2e4, 0.003);
  EXPECT_EQ(cell.run(300), ErrorCode::none);
  EXPECT_NEAR(cell.complying.displacement()[2], 0.003, 1e-6);
  EXPECT_NEAR(cell.mp.replies.back().desired_pose.translation().z(), 0.303, 1e-6);
  EXPECT_NEAR(cell.complying.displacement().head<2>().norm(), 0, 1e-12);
}

TEST(Complying, RestsWhereItsOwnSpringAndTheForceAreEqual) {
  check_property(100, [] {
    Compliance compliance;
    const double stiffness = *rc::gen::inRange(1000, 20000), own = *rc::gen::inRange(100, 10000);
    compliance.admittance.setConstant(4 / (stiffness + own));
    compliance.stiffness.setConstant(own);
    compliance.wrench[2] = *rc::gen::inRange(-5, 6);
    Cell cell(compliance, stiffness, 0.004);
    RC_ASSERT(cell.run(400) == ErrorCode::none);
    const double expected = (stiffness * 0.004 - compliance.wrench[2]) / (stiffness + own);
    RC_ASSERT(std::abs(cell.complying.displacement()[2] - expected) < 1e-6);
  });
}

TEST(Complying, StiffAxesStay) {
  Compliance compliance;
  compliance.admittance.setZero();
  Cell cell(compliance, 2e4, 0.003);
  EXPECT_EQ(cell.run(50), ErrorCode::none);
  EXPECT_TRUE(cell.complying.displacement().isZero(0));
  EXPECT_EQ(cell.mp.replies.back().desired_pose.translation(), Eigen::Vector3d(0.1, 0.2, 0.3));
}

TEST(Complying, GivesWayNoFartherThanItsTravel) {
  Compliance compliance;
  compliance.admittance.setConstant(2e-4);
  compliance.travel = 0.002;
  Cell cell(compliance, 2e4, 0.003);
  EXPECT_EQ(cell.run(300), ErrorCode::force_limit);
  EXPECT_EQ(cell.mp.replies.back().coordination, Coordination::left);
  EXPECT_EQ(cell.mp.replies.back().error.code, ErrorCode::force_limit);
}

TEST(Complying, IsWithoutDisplacementWhereTheMpPlansAgain) {
  Compliance compliance;
  compliance.admittance.setConstant(2e-4);
  Cell cell(compliance, 2e4, 0.003);
  const auto make = cell.mp.make;
  int made = 0;
  cell.mp.make = [&](const std::vector<RobotState>& replies) {
    return ++made == 200 ? item(CommandKind::query).command : make(replies);
  };
  double before = 0;
  cell.complying.until(
      When{"plan", [&] { return made == 199 ? before = cell.complying.displacement()[2], false : made == 201; }});
  Move({*cell.arm}, {}, cell.complying);
  EXPECT_NEAR(before, 0.003, 1e-5);
  EXPECT_TRUE(cell.complying.displacement().isZero(0));
}

TEST(Complying, RefusesWrongParameters) {
  FakeTask task;
  FakeMp mp;
  const auto arm = task.robot("arm");
  Superior superior(mp);
  const auto refuses = [&](auto change) {
    Compliance compliance;
    change(compliance);
    EXPECT_THROW(Complying(superior, *arm, compliance), NonFatalError);
  };
  refuses([](Compliance& c) { c.admittance[0] = -1; });
  refuses([](Compliance& c) { c.stiffness[5] = -1; });
  refuses([](Compliance& c) { c.wrench[1] = NAN; });
  refuses([](Compliance& c) { c.lag = 0; });
  refuses([](Compliance& c) { c.travel = 0; });
  refuses([](Compliance& c) { c.turn = INFINITY; });
  refuses([](Compliance& c) { c.acceleration = 0; });
  refuses([](Compliance& c) { c.angular_acceleration = -1; });
  refuses([](Compliance& c) { c.load.mass = -1; });
}

}  // namespace
}  // namespace mrroc::fakes::complying_test
