// What goes wrong on a bus or in a drive, at random moments of a motion: the robot stops inside its limits, the error
// names the drive and the cause, nothing moves any more, and `recover` works when the cause has gone.
#include <gtest/gtest.h>

#include <random>

#include "can_rig.hpp"
#include "edp/error_report.hpp"
#include "repetitions.hpp"

namespace mrroc::edp {
namespace {

using canopen::DriveMode;

constexpr int kAxis = 2;  // z, node 3

/// A bus whose transmit queue can be full, or whose interface can be down.
class WeakBus : public can::Bus {
 public:
  explicit WeakBus(std::unique_ptr<can::Bus> bus) : bus_(std::move(bus)) {}
  can::Sent send(const can::Frame& frame) noexcept override {
    return answer == can::Sent::yes ? bus_->send(frame) : answer;
  }
  bool receive(can::Frame& frame, std::int64_t deadline) noexcept override { return bus_->receive(frame, deadline); }
  void filter(std::span<const can::Filter> filters) override { bus_->filter(filters); }
  int descriptor() const noexcept override { return bus_->descriptor(); }
  bool carries_fd() const noexcept override { return bus_->carries_fd(); }
  can::Sent answer = can::Sent::yes;

 private:
  std::unique_ptr<can::Bus> bus_;
};

/// As the robots' files have it: what reads the same position while it is told to go on is stuck.
class Watched : public Gantry {
 public:
  Watched() {
    for (AxisParameters& axis : parameters_.axes) {
      axis.following_error_max = 1;
      axis.stuck_max = 0.25;
    }
  }
};

config::DriveTable watched_table(bool absolute_encoders) {
  config::DriveTable table = table_for(Watched{}.parameters(), DriveMode::cyclic_position);
  table.absolute_encoders = absolute_encoders;
  return table;
}

/// A gantry under way, with everything that may go wrong at hand.
class Rig {
 public:
  explicit Rig(unsigned seed, bool absolute_encoders = true)
      : random(seed),
        table(watched_table(absolute_encoders)),
        bus([this](can::Frame& frame) { return !spoil || spoil(frame); }),
        rack(table, model, bus, true) {
    auto weak = std::make_unique<WeakBus>(bus.open());
    weak_bus = weak.get();
    hardware = std::make_unique<CanHardware>(table, model.parameters(), kCanPeriod, std::move(weak), kTestTiming, true);
    hardware->open();
    servo = std::make_unique<Servo>(models, *hardware, kCanPeriod, hand_over);
    effector.enable(true);
    while (!servo->snapshot().enabled && now < 3000) tick();
    effector.accept(relative_joints(JointVector::Constant(4, 0.6), 1500), ++number, answer);
    const Tick moment = now + 50 + random() % 1000;
    while (now < moment) tick();
  }

  void tick() {
    servo->tick(now++);
    if (!servo->drives_on()) ::usleep(50);  // nobody who answers paces the ticks
    Reply reply;
    while (effector.poll(reply)) last = reply;
    const Snapshot& seen = servo->snapshot();
    for (int i = 0; i < 4; ++i) {
      const AxisParameters& axis = model.parameters().axes[static_cast<std::size_t>(i)];
      worst_speed = std::max(worst_speed, std::abs(seen.desired.velocity[i]) / axis.velocity_max);
    }
    const JointVector shafts = rack.shafts();
    if (shafts_.size() != 0) {
      const double speed = ((shafts - shafts_) / kCanPeriod / GearedModel::kGear).cwiseAbs().maxCoeff();
      worst_real_speed = std::max(worst_real_speed, speed / model.parameters().axes[0].velocity_max);
    }
    shafts_ = shafts;
  }
  /// Ticks until the servo has found a fault and its drives are off; then nothing may move.
  void stop() {
    const Tick begin = now;
    while ((servo->snapshot().fault.code == ErrorCode::none || servo->drives_on()) && now < begin + 3000) tick();
    stopped_after = now - begin;
    for (int i = 0; i < 300; ++i) tick();  // the drives' own ramps and watchdogs
    const JointVector there = rack.shafts();
    for (int i = 0; i < 50; ++i) tick();
    moved = (rack.shafts() - there).cwiseAbs().maxCoeff();
  }
  bool recover() {
    RobotCommand command;
    command.kind = CommandKind::recover;
    last = {};
    if (effector.accept(command, ++number, answer)) return false;
    for (int i = 0; i < 4000 && last.command != number; ++i) tick();
    return last.command == number && last.state.error.error_class == ErrorClass::none;
  }
  bool moves_again() {
    if (effector.accept(relative_joints(JointVector::Constant(4, 0.02), 400), ++number, answer)) return false;
    for (int i = 0; i < 500; ++i) tick();
    return last.command == number && last.state.error.error_class == ErrorClass::none;
  }
  const Fault& fault() const { return servo->snapshot().fault; }
  std::string text() const { return std::string(make_report(fault(), model.parameters()).detail.view()); }
  sim::DriveNode& node(std::vector<sim::DriveNode>& nodes) const { return nodes[kAxis]; }

  std::mt19937 random;
  Watched model;
  config::DriveTable table;
  can::Hub::Fault spoil;  ///< set while nothing is sent
  TestBus bus;
  Rack rack;
  WeakBus* weak_bus = nullptr;
  std::unique_ptr<CanHardware> hardware;
  HandOver hand_over;
  ModelSet models{model};
  std::unique_ptr<Servo> servo;
  Effector effector{models, kCanPeriod, hand_over};
  Tick now = 0;
  std::uint64_t number = 0;
  Reply answer, last;
  double worst_speed = 0, worst_real_speed = 0, moved = 0;
  Tick stopped_after = 0;

 private:
  JointVector shafts_;
};

/// One kind of fault.
struct Case {
  std::string name;
  std::vector<ErrorCode> codes;  ///< that it may be found as
  std::string text;              ///< in the error's
  std::function<void(Rig&)> begin;
  std::function<void(Rig&)> end;
  bool on_sockets = true;  ///< also where the kernel carries the frames
};

void with_node(Rig& rig, const std::function<void(sim::DriveNode&)>& action) {
  rig.rack.with([&](auto& nodes) { action(rig.node(nodes)); });
}

/// What the controller reports comes as a frame from outside.
void report(Rig& rig, std::uint32_t classes, std::uint8_t controller) {
  can::Frame frame{classes, {0, controller, 0, 0, 0, 0, 0, 0}};
  frame.error = true;
  rig.bus.open()->send(frame);
}

void nothing(Rig&) {}

std::vector<Case> cases() {
  return {
      {"NodeLost",
       {ErrorCode::hardware_silent},
       "axis 3 (z)",
       [](Rig& rig) { with_node(rig, [](auto& node) { node.cut(true); }); },
       [](Rig& rig) { with_node(rig, [](auto& node) { node.cut(false); }); }},
      {"HeartbeatLost",
       {ErrorCode::heartbeat_lost},
       "axis 3 (z)",
       [](Rig& rig) { with_node(rig, [](auto& node) { node.hush(true); }); },
       [](Rig& rig) { with_node(rig, [](auto& node) { node.hush(false); }); }},
      {"Emergency",
       {ErrorCode::drive_fault},
       "error code 7305h, incremental sensor 1 fault",
       [](Rig& rig) { with_node(rig, [](auto& node) { node.fail(0x7305); }); },
       nothing},
      {"Restarted",
       {ErrorCode::drive_restarted, ErrorCode::hardware_silent},
       "axis 3 (z)",
       [](Rig& rig) { with_node(rig, [](auto& node) { node.boot(0); }); },
       nothing},
      {"BusOff", {ErrorCode::bus_off}, "bus off", [](Rig& rig) { report(rig, 0x40, 0); }, nothing},
      {"ErrorPassive", {ErrorCode::bus_error}, "error passive", [](Rig& rig) { report(rig, 0x4, 0x20); }, nothing},
      {"QueueFull",
       {ErrorCode::bus_error},
       "transmit queue full",
       [](Rig& rig) { rig.weak_bus->answer = can::Sent::full; },
       [](Rig& rig) { rig.weak_bus->answer = can::Sent::yes; }},
      {"InterfaceDown",
       {ErrorCode::bus_off},
       "the interface is down",
       [](Rig& rig) { rig.weak_bus->answer = can::Sent::down; },
       [](Rig& rig) { rig.weak_bus->answer = can::Sent::yes; }},
      {"PositionStuck",
       {ErrorCode::axis_stuck, ErrorCode::following_error, ErrorCode::overspeed, ErrorCode::encoder_fault},
       "axis 3 (z)",
       [](Rig& rig) { with_node(rig, [](auto& node) { node.freeze(true); }); },
       [](Rig& rig) { with_node(rig, [](auto& node) { node.freeze(false); }); }},
      {"BitsTurnedOver",
       {ErrorCode::encoder_fault, ErrorCode::drive_fault, ErrorCode::drive_not_ready, ErrorCode::overspeed,
        ErrorCode::following_error, ErrorCode::axis_stuck},
       "axis 3 (z)",
       [](Rig& rig) {
         rig.spoil = [&rig](can::Frame& frame) {
           if (frame.id == 0x183) frame.data[rig.random() % 6] ^= static_cast<std::uint8_t>(1 + rig.random() % 255);
           return true;
         };
       },
       [](Rig& rig) { rig.spoil = {}; },
       false},
      {"FramesLost",
       {ErrorCode::hardware_silent},
       "axis 3 (z)",
       [](Rig& rig) { rig.spoil = [](can::Frame& frame) { return frame.id != 0x183; }; },
       [](Rig& rig) { rig.spoil = {}; },
       false},
  };
}

/// Random moments that each fault is tried at: MRROC_TEST_SEEDS, else 20.
unsigned seeds() {
  const char* const given = std::getenv("MRROC_TEST_SEEDS");
  return given != nullptr ? static_cast<unsigned>(std::atoi(given)) : test::repetitions(20u);
}

class BusFault : public testing::TestWithParam<Case> {};

TEST_P(BusFault, StopsTheRobotAndCanBeRecovered) {
  const Case& fault = GetParam();
  for (unsigned seed = 1; seed <= seeds(); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Rig rig(seed);
    if (!rig.bus.is_hub() && !fault.on_sockets) return;
    ASSERT_EQ(rig.fault().code, ErrorCode::none) << describe(rig.fault().code);
    fault.begin(rig);
    rig.stop();
    EXPECT_NE(std::find(fault.codes.begin(), fault.codes.end(), rig.fault().code), fault.codes.end())
        << describe(rig.fault().code) << " " << rig.text();
    EXPECT_NE(rig.text().find(fault.text), std::string::npos) << rig.text();
    EXPECT_LE(rig.stopped_after, 300u);
    EXPECT_LE(rig.worst_speed, 1 + 1e-6);
    EXPECT_LE(rig.worst_real_speed, 1.5);
    EXPECT_LT(rig.moved, 0.01) << "rad of a shaft, after the stop";
    fault.end(rig);
    for (int i = 0; i < 20; ++i) rig.tick();
    ASSERT_TRUE(rig.recover()) << rig.text() << " " << rig.last.state.error.detail.view();
    EXPECT_TRUE(rig.moves_again()) << rig.text() << " " << rig.last.state.error.detail.view();
  }
}

INSTANTIATE_TEST_SUITE_P(Can, BusFault, testing::ValuesIn(cases()), [](const auto& each) { return each.param.name; });

TEST(BusFault, ADriveThatHasRestartedWithoutAnAbsoluteEncoderIsNotSynchronised) {
  Rig rig(1, false);
  with_node(rig, [](auto& node) { node.boot(0); });
  rig.stop();
  EXPECT_EQ(rig.fault().code, ErrorCode::drive_restarted);
  EXPECT_FALSE(rig.servo->snapshot().synchronised);
  EXPECT_TRUE(rig.recover()) << rig.text();
  EXPECT_TRUE(rig.servo->snapshot().enabled);
  EXPECT_FALSE(rig.moves_again()) << "joints are not known";
}

TEST(BusFault, WhoeverBabblesDoesNotMakeTheRobotUnsafe) {
  for (unsigned seed = 1; seed <= seeds(); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Rig rig(seed);
    const auto babbler = rig.bus.open();
    for (int i = 0; i < 300; ++i) {
      for (int j = 0; j < 20; ++j) {
        can::Frame frame;
        frame.id = rig.random() % 0x800;
        frame.size = static_cast<std::uint8_t>(rig.random() % 9);
        for (std::uint8_t& byte : frame.data) byte = static_cast<std::uint8_t>(rig.random());
        // what resets or starts drives, or claims to be their SYNC or master, no driver can stop
        const std::uint32_t function = frame.id & 0x780;
        if (frame.id == 0 || frame.id == 0x80 || function == 0x200 || function == 0x600) continue;
        babbler->send(frame);
      }
      rig.tick();
    }
    EXPECT_LE(rig.worst_speed, 1 + 1e-6);
    EXPECT_LE(rig.worst_real_speed, 1.5);
    if (rig.fault().code == ErrorCode::none) continue;
    rig.stop();
    EXPECT_LT(rig.moved, 0.01);
    bool recovered = false;
    for (int i = 0; i < 4 && !recovered; ++i) recovered = rig.recover();
    EXPECT_TRUE(recovered) << rig.text();
  }
}

}  // namespace
}  // namespace mrroc::edp
