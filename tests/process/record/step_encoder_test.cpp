// A step as its process encodes it: `mrroc trace check` can read it.
#include "process/record/step_encoder.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "allocations.hpp"
#include "cli/trace/step_line.hpp"
#include "language/fakes.hpp"
#include "messages/cdr_reader.hpp"

namespace mrroc::process::step_encoder_test {
namespace {

using cli::trace::Line;

class Reported : public testing::Test {
 protected:
  Reported() {
    config::SensorEntry entry;
    entry.name = "eye";
    entry.polled = true;
    deployment.sensors.push_back(entry);
    task.add_sensor("gate", false);
    for (const char* robot : {"arm", "belt"}) robots.push_back(task.robot(robot, 2));
    for (const char* sensor : {"gate", "eye"}) sensors.push_back(task.sensor(sensor));
    for (const auto& robot : robots) robot_list.push_back(robot.get());
    auto instruction = std::make_shared<InstructionRecord>();
    instruction->is_move = true;
    instruction->number = 3;
    instruction->name = "Together";
    instruction->until = "a or b";
    instruction->robots = {"arm", "belt"};
    instruction->sensors = {{"gate", 5, false}, {"eye", 1, true}};
    record.instruction = instruction;
    record.step = 7;
    record.held = 2;
    record.tick = 1234;
  }

  /// The robot's state is that of its fake.
  void receive() {
    for (Robot* robot : robot_list) {
      robot->reset_command(CommandKind::query);
      robot->send();
      robot->receive();
    }
    for (const auto& sensor : sensors) sensor->collect_reading();
  }

  /// The call of a Move at this step.
  void fill() {
    record.states.clear();
    record.commands.clear();
    record.readings.clear();
    for (Robot* robot : robot_list) record.states.push_back(robot->state());
    if (!record.last())
      for (Robot* robot : robot_list) record.commands.push_back(robot->command());
    for (const auto& sensor : sensors) record.readings.push_back(sensor->reading());
  }

  Line line() {
    fill();
    encode_step(step, deployment, "mp", record);
    const auto message = messages::from_cdr<messages::mrroc_msgs::Step>(step.view());
    const std::vector<std::byte> again = messages::to_cdr(message);
    EXPECT_TRUE(std::equal(again.begin(), again.end(), step.view().begin(), step.view().end())) << "to the last byte";
    return cli::trace::to_line(message);
  }

  fakes::FakeTask task;
  config::Deployment deployment;
  std::vector<std::unique_ptr<Robot>> robots;
  std::vector<std::unique_ptr<Sensor>> sensors;
  std::vector<Robot*> robot_list;
  StepRecord record;
  EncodedStep step;
};

TEST_F(Reported, StateCommandAndReadingsAreRead) {
  fakes::FakeRobotLink& arm = task.robot_fake("arm");
  arm.state.macrostep_start = 990;
  arm.state.desired_velocity[1] = 0.1;
  arm.state.desired_pose.translation() = Eigen::Vector3d(0.1, 0.2, 0.3);
  arm.state.late_commands = 4;
  arm.state.wrench[2] = -3;
  arm.state.lost = 0.125;
  arm.errors[0] = {ErrorClass::hardware, ErrorCode::drive_fault, {}};
  receive();
  robot_list[0]->reset_command(CommandKind::joint);
  robot_list[0]->command().joints = JointVector::Constant(2, 1.0 / 3);
  robot_list[0]->command().start_tick = 1002;
  robot_list[1]->reset_command(CommandKind::force);
  const Line read = line();
  EXPECT_EQ(read.process, "mp");
  EXPECT_EQ(read.until, "a or b");
  EXPECT_EQ(read.held, 2U);
  EXPECT_EQ(read.robots[0].macrostep, 990U);
  EXPECT_TRUE(read.robots[0].moving);
  EXPECT_FALSE(read.robots[1].moving);
  EXPECT_EQ(read.robots[0].desired_pose[2], 0.3);
  EXPECT_EQ(read.robots[0].late, 4U);
  EXPECT_EQ(read.robots[0].wrench[2], -3);
  EXPECT_EQ(read.robots[0].lost, 0.125);
  EXPECT_EQ(read.robots[1].lost, 0);
  EXPECT_EQ(read.robots[0].error, ErrorClass::hardware);
  EXPECT_EQ(read.robots[0].error_code, "a drive reports a fault");
  EXPECT_EQ(read.robots[0].command->target, (cli::trace::Numbers{1.0 / 3, 1.0 / 3}));
  EXPECT_EQ(read.robots[0].command->start_tick, 1002U);
  EXPECT_EQ(read.robots[1].command->behaviour, "uuuuuu");
  EXPECT_EQ(read.sensors[0].period, 5U);
  EXPECT_EQ(read.sensors[0].mode, cli::trace::SensorMode::published);
  EXPECT_EQ(read.sensors[1].mode, cli::trace::SensorMode::polled);
  EXPECT_FALSE(read.ends());
  EXPECT_FALSE(read.skew.has_value());
}

TEST_F(Reported, EveryKindOfCommandIsRead) {
  receive();
  for (int kind = 0; kind <= static_cast<int>(CommandKind::set_outputs); ++kind) {
    robot_list[0]->reset_command(static_cast<CommandKind>(kind));
    robot_list[0]->command().joints = robot_list[0]->command().joint_velocity = JointVector::Constant(2, 0.5);
    robot_list[0]->command().relative = kind % 2 == 0;
    robot_list[0]->command().interpolation = static_cast<Interpolation>(kind % 3);
    const CommandKind read = line().robots[0].command->kind;
    EXPECT_EQ(read, std::min(static_cast<CommandKind>(kind), CommandKind::set_tool));
  }
}

TEST_F(Reported, EveryEndingIsRead) {
  receive();
  record.skew = 3;
  for (int ending = 1; ending <= static_cast<int>(StepEnding::system_error); ++ending) {
    record.ending = static_cast<StepEnding>(ending);
    const Line read = line();
    EXPECT_EQ(read.ending, record.ending);
    EXPECT_EQ(read.skew, 3U);
    EXPECT_FALSE(read.robots[0].command.has_value());
  }
}

TEST_F(Reported, StateThatWasNeverReceivedIsRead) {
  record.ending = StepEnding::system_error;
  EXPECT_TRUE(line().robots[0].joints.empty());
}

TEST_F(Reported, StepThatIsTooLongIsMarked) {
  receive();
  record.ending = StepEnding::condition;
  auto instruction = std::make_shared<InstructionRecord>(*record.instruction);
  instruction->conditions.assign(300, std::string(100, 'x'));
  record.instruction = instruction;
  record.conditions.assign(300, 1);
  const Line read = line();
  EXPECT_TRUE(read.cut);
  EXPECT_EQ(read.name, "Together");
  EXPECT_EQ(read.step, 7U);
  EXPECT_TRUE(read.robots.empty());
  EXPECT_FALSE(read.ends());
}

TEST_F(Reported, NamesOfAStepThatIsTooLongAreShortened) {
  receive();
  auto instruction = std::make_shared<InstructionRecord>(*record.instruction);
  instruction->name = instruction->until.emplace(2 * EncodedStep::kCapacity, 'y');
  record.instruction = instruction;
  const Line read = line();
  EXPECT_TRUE(read.cut);
  EXPECT_EQ(read.name, std::string(1000, 'y'));
  EXPECT_EQ(read.until, std::string(1000, 'y'));
}

TEST_F(Reported, ReportDoesNotAllocate) {
  receive();
  fill();
  encode_step(step, deployment, "mp", record);
  const std::uint64_t before = test::allocations();
  encode_step(step, deployment, "mp", record);
  EXPECT_EQ(test::allocations(), before);
}

}  // namespace
}  // namespace mrroc::process::step_encoder_test
