#include <gtest/gtest.h>

#include <optional>

#include "can_rig.hpp"
#include "edp/check/switched_gantry.hpp"
#include "edp/safety/error_report.hpp"
#include "edp/servo/drive_homing.hpp"

namespace mrroc::edp {
namespace {

using canopen::DriveMode;

/// Its axes start beside their switches.
class Beside : public Switched {
 public:
  Beside() { parameters_.home = JointVector::Constant(4, 0.05); }
};

RobotCommand synchronise() {
  RobotCommand command;
  command.kind = CommandKind::synchronise;
  return command;
}

template <class Model>
void expect_synchronisation(CanRig<Model>& rig) {
  ASSERT_FALSE(rig.send(synchronise())) << rig.answer.state.error.detail.view();
  while (rig.replies.empty() && rig.now < 60'000) rig.tick();
  ASSERT_EQ(rig.replies.size(), 1u);
  EXPECT_EQ(rig.replies[0].state.error.error_class, ErrorClass::none) << rig.replies[0].state.error.detail.view();
  EXPECT_TRUE(rig.seen().synchronised);
}

TEST(DriveHoming, EveryAxisFindsItsZeroPulse) {
  CanRig<Beside> rig(DriveMode::cyclic_position, false);
  ASSERT_TRUE(rig.seen().enabled()) << describe(rig.seen().fault.code);
  EXPECT_FALSE(rig.seen().synchronised);
  ASSERT_NO_FATAL_FAILURE(expect_synchronisation(rig));
  // at its zero pulse, or past it by the stopping distance at the fine speed
  for (int i = 0; i < 4; ++i) EXPECT_NEAR(rig.seen().motors[i], -15.9, 0.3) << i;

  // and it continues from there
  rig.replies.clear();
  const JointVector begin = rig.seen().joints;
  ASSERT_FALSE(rig.send(relative_joints(JointVector::Constant(4, 0.1), 400))) << rig.answer.state.error.detail.view();
  rig.run(500);
  EXPECT_EQ(rig.seen().fault.code, ErrorCode::none);
  EXPECT_LT((rig.seen().joints - begin - JointVector::Constant(4, 0.1)).cwiseAbs().maxCoeff(), 1e-3);
}

/// Homing methods refer to the drive's own direction of counting.
TEST(DriveHoming, ReversedCounterMovesTheSameWay) {
  config::DriveTable table = table_for(Beside{}.parameters(), DriveMode::cyclic_position);
  for (config::DriveEntry& drive : table.drives) {
    drive.units_per_turn = drive.velocity_units_per_turn = -drive.units_per_turn;
    drive.homing.method = drive.homing.method == 3 ? 5 : 3;
  }
  CanRig<Beside> rig(table, false);
  ASSERT_TRUE(rig.seen().enabled()) << describe(rig.seen().fault.code);
  ASSERT_NO_FATAL_FAILURE(expect_synchronisation(rig));
  for (int i = 0; i < 4; ++i) EXPECT_NEAR(rig.seen().motors[i], -15.9, 0.3) << i;
}

/// It has no switches.
class Unswitched : public Beside {
 public:
  Unswitched() {
    for (AxisParameters& axis : parameters_.axes) axis.synchro_coarse = axis.synchro_fine = 0;
  }
};

TEST(DriveHoming, AxisWithoutASwitchIsAtThePositionOfItsDrive) {
  config::DriveTable table = table_for(Unswitched{}.parameters(), DriveMode::cyclic_position);
  for (config::DriveEntry& drive : table.drives) drive.homing.method = 37;
  CanRig<Unswitched> rig(table, false);
  ASSERT_TRUE(rig.seen().enabled()) << describe(rig.seen().fault.code);
  ASSERT_NO_FATAL_FAILURE(expect_synchronisation(rig));
  for (int i = 0; i < 4; ++i) EXPECT_NEAR(rig.seen().motors[i], -15.9, 0.01) << i;
}

TEST(DriveHoming, UnsupportedMethodEndsTheSynchronisation) {
  config::DriveTable table = table_for(Beside{}.parameters(), DriveMode::cyclic_position);
  table.drives[2].homing.method = 14;
  CanRig<Beside> rig(table, false);
  ASSERT_FALSE(rig.send(synchronise()));
  while (rig.seen().fault.code == ErrorCode::none && rig.now < 60'000) rig.tick();
  EXPECT_EQ(rig.seen().fault.code, ErrorCode::synchronisation_failed)
      << make_report(rig.seen().fault, rig.model.parameters()).detail.view();
  EXPECT_EQ(rig.seen().fault.axis, 2);
  EXPECT_FALSE(rig.seen().synchronised);
}

template <class Model>
void stay_in(CanRig<Model>& rig, std::optional<DriveMode> mode) {
  rig.rack.with([mode](auto& nodes) {
    for (sim::DriveNode& node : nodes) node.stay_in(mode);
  });
}

template <class Model>
std::string fault_of(CanRig<Model>& rig) {
  while (rig.seen().fault.code == ErrorCode::none && rig.now < 60'000) rig.tick();
  EXPECT_EQ(rig.seen().fault.code, ErrorCode::drive_not_ready);
  const std::string text(make_report(rig.seen().fault, rig.model.parameters()).detail.view());
  return text.substr(text.find(": ") + 2);
}

TEST(DriveHoming, WaitsForALateModeDisplay) {
  CanRig<Beside> rig(DriveMode::cyclic_position, false);
  stay_in(rig, DriveMode::cyclic_position);
  ASSERT_FALSE(rig.send(synchronise()));
  rig.run(500);
  EXPECT_LT(rig.seen().motors.cwiseAbs().maxCoeff(), 0.1) << "it stands";
  stay_in(rig, {});
  while (rig.replies.empty() && rig.now < 60'000) rig.tick();
  EXPECT_TRUE(rig.seen().synchronised) << make_report(rig.seen().fault, rig.model.parameters()).detail.view();
}

TEST(DriveHoming, DriveThatNeverEntersItsModeIsNotReady) {
  CanRig<Beside> rig(DriveMode::cyclic_position, false);
  stay_in(rig, DriveMode::cyclic_position);
  ASSERT_FALSE(rig.send(synchronise()));
  EXPECT_EQ(fault_of(rig), "mode display 8, wanted 6");
  EXPECT_FALSE(rig.seen().synchronised);
}

TEST(DriveHoming, DriveThatStaysInHomingModeIsNotReady) {
  config::DriveTable table = table_for(Unswitched{}.parameters(), DriveMode::cyclic_position);
  for (config::DriveEntry& drive : table.drives) drive.homing.method = 37;
  CanRig<Unswitched> rig(table, false);
  ASSERT_FALSE(rig.send(synchronise()));
  rig.run(50);
  stay_in(rig, DriveMode::homing);
  EXPECT_EQ(fault_of(rig), "mode display 6, wanted 8");
  EXPECT_FALSE(rig.seen().synchronised);
}

TEST(DriveHoming, EmergencyStopIsTheDrivesQuickStop) {
  CanRig<Beside> rig(DriveMode::cyclic_position, false);
  rig.servo.use_emergency_stop(rig.operators);
  rig.run(2);
  ASSERT_FALSE(rig.send(synchronise()));
  rig.run(60);
  const JointVector begin = rig.seen().motors;
  rig.run(20);
  ASSERT_GT((rig.seen().motors - begin).norm(), 0.1) << "it is moving";
  rig.operators.press();
  rig.run(200);
  EXPECT_EQ(rig.seen().fault.code, ErrorCode::emergency_stop);
  EXPECT_FALSE(rig.seen().enabled());
  const JointVector there = rig.rack.shafts();
  rig.run(50);
  EXPECT_EQ(rig.rack.shafts(), there) << "it stands";
}

}  // namespace
}  // namespace mrroc::edp
