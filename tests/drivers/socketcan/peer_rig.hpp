// Third-party drives, CiA 402 nodes of python-canopen (tests/can/peer_drive.py) with an object dictionary from an EDS
// file, and the driver above them. Their motors advance by one period at each SYNC, because Python may pause.
#pragma once

#include <gtest/gtest.h>

#include <cstdio>

#include "can_rig.hpp"
#include "edp/safety/error_report.hpp"

namespace mrroc::edp {

inline constexpr double kPeerPeriod = 0.01;             // Python can keep up with it
inline constexpr CanHardware::Timing kPeerTiming{0.5};  // longer than Python's pauses
inline constexpr double kPeerRatedCurrent =
    300;                                 // A: with it 1 A accelerates a slide's motor as fast as Python's shaft
inline constexpr double kHeartbeat = 1;  // s; three are longer than the SYNCs until a silent node is lost

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

/// peer_drive.py with drives of these node numbers, and `more` arguments.
class Peer {
 public:
  explicit Peer(const std::string& bus, const std::string& more = "", const std::string& nodes = "1 2") {
    const std::string source = MRROC_SOURCE_DIR;
    const std::string command = "PYTHONPATH=" + source + "/.deps/python exec python3 " + source +
                                "/tests/can/peer_drive.py --bus " + bus + " --eds " + source +
                                "/src/canopen/cia402.eds --cycle " + std::to_string(kPeerPeriod) + " " + nodes + " " +
                                more + " > /dev/null";
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

/// A tick takes at least a period: the nodes' heartbeats run in real time.
inline void pause() { ::usleep(static_cast<useconds_t>(kPeerPeriod * 1e6)); }

class PeerTest : public testing::TestWithParam<canopen::DriveMode> {
 protected:
  explicit PeerTest(const std::string& more = "", const std::string& nodes = "1 2") : peer(bus.name(), more, nodes) {}
  /// Where the drives are on the bus.
  virtual void place(config::DriveTable& /*drives*/) const {}
  void SetUp() override {
    table = table_for(model.parameters(), GetParam());
    table.heartbeat = kHeartbeat;
    table.absolute_encoders = true;
    place(table);
    for (config::DriveEntry& drive : table.drives) drive.settings = settings;
    if (GetParam() == canopen::DriveMode::cyclic_torque)
      for (config::DriveEntry& drive : table.drives) drive.rated_current = kPeerRatedCurrent;
    hardware = std::make_unique<CanHardware>(table, model.parameters(), kPeerPeriod, bus.opener(), kPeerTiming, true);
    hardware->open();
    servo = std::make_unique<Servo>(models, *hardware, kPeerPeriod, hand_over);
    effector.enable(true);
    while (!seen().enabled() && seen().fault.code == ErrorCode::none && now < 500) tick();
    ASSERT_TRUE(seen().enabled()) << text();
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

  std::vector<config::NodeSetting> settings;  ///< of each drive, in addition to the driver's own
  TwoSlides model;
  config::DriveTable table;
  TestBus bus;
  Peer peer;
  std::unique_ptr<CanHardware> hardware;
  ServoChannel hand_over;
  ModelSet models{model};
  std::unique_ptr<Servo> servo;
  Effector effector{models, kPeerPeriod, hand_over};
  Tick now = 0;
  std::uint64_t number = 0;
  Reply last;
};

inline std::string name_of_mode(const testing::TestParamInfo<canopen::DriveMode>& each) {
  return each.param == canopen::DriveMode::cyclic_position   ? "Position"
         : each.param == canopen::DriveMode::cyclic_velocity ? "Velocity"
                                                             : "Torque";
}

inline auto every_mode() {
  using enum canopen::DriveMode;
  return testing::Values(cyclic_position, cyclic_velocity, cyclic_torque);
}

}  // namespace mrroc::edp
