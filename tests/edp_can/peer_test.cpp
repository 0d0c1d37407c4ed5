// The driver against drives that are not ours: CiA 402 nodes of python-canopen (tests/can/peer_drive.py), with an
// object dictionary from an EDS file. Their motors turn by one period at each SYNC: Python may pause.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "can_rig.hpp"
#include "edp/error_report.hpp"

namespace mrroc::edp {
namespace {

using canopen::DriveMode;

constexpr double kPeerPeriod = 0.01;             // what Python keeps up with
constexpr CanHardware::Timing kPeerTiming{0.5};  // longer than it pauses
constexpr double kPeerRatedCurrent = 300;        // A: with it a slide's motor gets as fast from 1 A as Python's shaft
constexpr double kHeartbeat = 1;                 // s; three are longer than the SYNCs until a silent node is lost

/// Two slides that synchronise to the positive side.
class TwoSlides : public Gantry {
 public:
  TwoSlides() {
    parameters_.axes.resize(2);
    parameters_.home = JointVector::Zero(2);
    for (AxisParameters& axis : parameters_.axes) {
      axis.motor_min = -100;
      axis.motor_max = 100;
      axis.motor_synchro = 12.5;
      axis.synchro_coarse = 8;
      axis.synchro_fine = -2;
      axis.following_error_max = 20;
    }
  }
  Pose flange(const JointVector& joints) const noexcept override {
    return Pose(Eigen::Translation3d(joints[0], joints[1], 0));
  }
};

/// peer_drive.py with nodes 1 and 2.
class Peer {
 public:
  explicit Peer(const std::string& bus) {
    const std::string source = MRROC_SOURCE_DIR;
    const std::string command = "PYTHONPATH=" + source + "/.deps/python exec python3 " + source +
                                "/tests/can/peer_drive.py --bus " + bus + " --eds " + source +
                                "/src/canopen/cia402.eds --cycle " + std::to_string(kPeerPeriod) + " 1 2 > /dev/null";
    input_ = ::popen(command.c_str(), "w");
  }
  ~Peer() {
    say("die");
    ::pclose(input_);
  }
  void say(const std::string& line) {
    std::fputs((line + "\n").c_str(), input_);
    std::fflush(input_);
  }

 private:
  std::FILE* input_;
};

/// A tick takes a period at least: the nodes' heartbeats keep their own time.
void pause() { ::usleep(static_cast<useconds_t>(kPeerPeriod * 1e6)); }

class PeerTest : public testing::TestWithParam<DriveMode> {
 protected:
  void SetUp() override {
    table = table_for(model.parameters(), GetParam());
    table.heartbeat = kHeartbeat;
    table.absolute_encoders = true;
    if (GetParam() == DriveMode::cyclic_torque)
      for (config::DriveEntry& drive : table.drives) drive.rated_current = kPeerRatedCurrent;
    hardware = std::make_unique<CanHardware>(table, model.parameters(), kPeerPeriod, bus.open(), kPeerTiming, true);
    hardware->open();
    servo = std::make_unique<Servo>(models, *hardware, kPeerPeriod, hand_over);
    effector.enable(true);
    while (!seen().enabled && seen().fault.code == ErrorCode::none && now < 500) tick();
    ASSERT_TRUE(seen().enabled) << text();
  }
  void tick() {
    pause();
    servo->tick(now++);
    Reply reply;
    while (effector.poll(reply)) last = reply;
  }
  void run(Tick ticks) {
    for (Tick i = 0; i < ticks; ++i) tick();
  }
  bool send(const RobotCommand& command) { return effector.accept(command, ++number, last); }
  bool do_now(CommandKind kind, Tick patience) {
    RobotCommand command;
    command.kind = kind;
    last = {};
    if (send(command)) return false;
    for (Tick i = 0; i < patience && last.command != number; ++i) tick();
    return last.command == number && last.state.error.error_class == ErrorClass::none;
  }
  const Snapshot& seen() const { return servo->snapshot(); }
  std::string text() const { return std::string(make_report(seen().fault, model.parameters()).detail.view()); }

  TwoSlides model;
  config::DriveTable table;
  TestBus bus;
  Peer peer{bus.name()};
  std::unique_ptr<CanHardware> hardware;
  HandOver hand_over;
  ModelSet models{model};
  std::unique_ptr<Servo> servo;
  Effector effector{models, kPeerPeriod, hand_over};
  Tick now = 0;
  std::uint64_t number = 0;
  Reply last;
};

TEST_P(PeerTest, MovesStopsOnAnEmergencyRecoversAndMovesAgain) {
  const JointVector begin = seen().joints;
  ASSERT_FALSE(send(relative_joints(JointVector::Constant(2, 0.2), 100))) << last.state.error.detail.view();
  run(160);
  EXPECT_EQ(seen().fault.code, ErrorCode::none) << text();
  EXPECT_NEAR(seen().joints[0] - begin[0], 0.2, 0.02);
  EXPECT_NEAR(seen().joints[1] - begin[1], 0.2, 0.02);

  ASSERT_FALSE(send(relative_joints(JointVector::Constant(2, 0.2), 200)));
  run(60);
  peer.say("node 2 emcy 0x7305");
  for (int i = 0; i < 200 && seen().fault.code == ErrorCode::none; ++i) tick();
  EXPECT_EQ(seen().fault.code, ErrorCode::drive_fault) << describe(seen().fault.code);
  EXPECT_NE(text().find("axis 2 (y)"), std::string::npos) << text();
  EXPECT_NE(text().find("7305h, incremental sensor 1 fault"), std::string::npos) << text();
  run(50);
  const JointVector there = seen().joints;
  run(30);
  EXPECT_LT((seen().joints - there).cwiseAbs().maxCoeff(), 1e-3) << "it stands";

  EXPECT_TRUE(do_now(CommandKind::recover, 600)) << text() << " " << last.state.error.detail.view();
  ASSERT_FALSE(send(relative_joints(JointVector::Constant(2, -0.1), 100))) << last.state.error.detail.view();
  run(160);
  EXPECT_EQ(seen().fault.code, ErrorCode::none) << text();
  EXPECT_NEAR(seen().joints[0] - there[0], -0.1, 0.02);
}

TEST_P(PeerTest, WhenOneFailsTheOtherIsStoppedQuicklyByItsDrive) {
  ASSERT_FALSE(send(relative_joints(JointVector::Constant(2, 0.4), 200)));
  run(60);
  const auto listener = bus.open();
  peer.say("node 2 emcy 0x7305");
  for (int i = 0; i < 200 && seen().fault.code == ErrorCode::none; ++i) tick();
  const double where = seen().joints[0];
  run(80);
  bool told = false;
  std::vector<canopen::DriveState> states;
  can::Frame frame;
  while (listener->receive(frame, 0)) {
    const auto word = static_cast<std::uint16_t>(can::get(frame.bytes(), 0, 2));
    if (frame.id == 0x201 && word == canopen::kQuickStop) told = true;
    if (frame.id != 0x181) continue;
    const canopen::DriveState state = canopen::drive_state(word);
    if (states.empty() || states.back() != state) states.push_back(state);
  }
  EXPECT_TRUE(told) << "its controlword";
  using enum canopen::DriveState;
  EXPECT_EQ(states, (std::vector{operation_enabled, quick_stop_active, switch_on_disabled}));
  EXPECT_GT(seen().joints[0], where) << "on a ramp of its own";
  const JointVector there = seen().joints;
  run(30);
  EXPECT_LT((seen().joints - there).cwiseAbs().maxCoeff(), 1e-3) << "it stands";
}

TEST_P(PeerTest, ASilentNodeIsLost) {
  peer.say("node 1 silence");
  for (int i = 0; i < 300 && seen().fault.code == ErrorCode::none; ++i) tick();
  EXPECT_TRUE(seen().fault.code == ErrorCode::hardware_silent || seen().fault.code == ErrorCode::heartbeat_lost)
      << describe(seen().fault.code);
  EXPECT_EQ(seen().fault.axis, 0);
}

TEST_P(PeerTest, ASecondRunFindsThemInTheirFaultAndGoesOn) {
  hardware.reset();
  // Python's drives keep their own time: longer than they wait for our heartbeat
  ::usleep(static_cast<useconds_t>(3.5 * kHeartbeat * 1e6));
  const auto second =
      std::make_unique<CanHardware>(table, model.parameters(), kPeerPeriod, bus.open(), kPeerTiming, true);
  second->open();
  HardwareInput input;
  second->read(0, input);
  EXPECT_EQ(input.fault, ErrorCode::none) << describe(input.fault);
}

INSTANTIATE_TEST_SUITE_P(Can, PeerTest,
                         testing::Values(DriveMode::cyclic_position, DriveMode::cyclic_velocity,
                                         DriveMode::cyclic_torque),
                         [](const auto& each) {
                           return std::string(each.param == DriveMode::cyclic_position   ? "Position"
                                              : each.param == DriveMode::cyclic_velocity ? "Velocity"
                                                                                         : "Torque");
                         });

/// Drives that begin to count where their power came on, and home by `method` of CiA 402. They have been turned by 5
/// rad before: the home switch of Python's drives is where they began.
class PeerHoming : public testing::TestWithParam<int> {
 protected:
  PeerHoming() {
    table.heartbeat = kHeartbeat;
    for (config::DriveEntry& drive : table.drives) drive.homing.method = static_cast<std::int8_t>(GetParam());
    hardware = std::make_unique<CanHardware>(table, model.parameters(), kPeerPeriod, bus.open(), kPeerTiming, false);
    hardware->open();
    servo = std::make_unique<Servo>(models, *hardware, kPeerPeriod, hand_over);
    effector.enable(true);
    while (!servo->snapshot().enabled && now < 500) tick();
  }
  void tick() {
    pause();
    servo->tick(now++);
    while (effector.poll(reply)) {
    }
    if (!servo->snapshot().synchronised) least = std::min(least, servo->snapshot().motors.maxCoeff());
  }

  TwoSlides model;
  config::DriveTable table = table_for(model.parameters(), DriveMode::cyclic_position);
  TestBus bus;
  Peer peer{bus.name()};
  std::unique_ptr<CanHardware> hardware;
  HandOver hand_over;
  ModelSet models{model};
  std::unique_ptr<Servo> servo;
  Effector effector{models, kPeerPeriod, hand_over};
  Reply reply;
  Tick now = 0;
  double least = 1e9;  ///< rad, of the shaft that was farther out
};

TEST_P(PeerHoming, FindsItsPositions) {
  ASSERT_TRUE(servo->snapshot().enabled);
  const double begin = servo->snapshot().motors.maxCoeff();
  RobotCommand turn;
  turn.kind = CommandKind::motor;
  turn.relative = true;
  turn.joints = JointVector::Constant(2, 5);
  turn.motion_steps = 200;
  ASSERT_FALSE(effector.accept(turn, 1, reply)) << reply.state.error.detail.view();
  for (int i = 0; i < 250; ++i) tick();
  EXPECT_NEAR(servo->snapshot().motors.maxCoeff() - begin, 5, 0.1);
  least = 1e9;

  RobotCommand synchronise;
  synchronise.kind = CommandKind::synchronise;
  ASSERT_FALSE(effector.accept(synchronise, 2, reply)) << reply.state.error.detail.view();
  for (int i = 0; i < 1500 && !servo->snapshot().synchronised; ++i) tick();
  ASSERT_TRUE(servo->snapshot().synchronised) << make_report(servo->snapshot().fault, model.parameters()).detail.view();
  for (int i = 0; i < 2; ++i) EXPECT_NEAR(servo->snapshot().motors[i], 12.5, 0.1) << i;
  const bool to_the_switch = GetParam() != 37;
  EXPECT_EQ(least < begin + 1, to_the_switch) << "method 37 takes the place where it is; least " << least - begin;
}

INSTANTIATE_TEST_SUITE_P(Can, PeerHoming, testing::Values(3, 37),
                         [](const auto& each) { return "Method" + std::to_string(each.param); });

}  // namespace
}  // namespace mrroc::edp
