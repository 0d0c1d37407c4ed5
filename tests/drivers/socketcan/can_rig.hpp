#pragma once

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <numbers>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "can/hub.hpp"
#include "drivers/loopback/loopback_hardware.hpp"
#include "drivers/socketcan/can_hardware.hpp"
#include "edp/command/effector.hpp"
#include "edp/servo/servo.hpp"
#include "edp/test_robots.hpp"
#include "mrroc/testing/scratch_folder.hpp"
#include "sim/can/drive_rack.hpp"

namespace mrroc::edp {

inline constexpr double kCanPeriod = 0.002;
/// Ticks as fast as the bus allows; a busy machine does not make a node silent.
inline constexpr CanHardware::Timing kTestTiming{0.5};

/// A table of drives for any robot: nodes 1, 2, ...
inline config::DriveTable table_for(const RobotParameters& robot, canopen::DriveMode mode) {
  config::DriveTable table;
  table.file = "test";
  table.mode = mode;
  table.target_at_sync = mode != canopen::DriveMode::cyclic_torque;
  table.heartbeat = 0.02;
  table.eds = canopen::EdsFile::load(std::filesystem::path(MRROC_SOURCE_DIR) / "src/canopen/cia402.eds");
  for (const AxisParameters& axis : robot.axes) {
    config::DriveEntry drive;
    drive.axis = axis.name;
    drive.node = static_cast<canopen::NodeId>(table.drives.size() + 1);
    drive.units_per_turn = drive.velocity_units_per_turn = axis.encoder_increments;
    drive.rated_current = 10;
    drive.position_gain = 20;
    drive.homing = {static_cast<std::int8_t>(axis.synchro_coarse > 0 ? 3 : 5), std::abs(axis.synchro_coarse),
                    std::abs(axis.synchro_fine)};
    table.drives.push_back(drive);
  }
  return table;
}

/// The standard EDS file with `text` in place of `found`, the first one.
inline canopen::EdsFile changed_eds(const std::string& found, const std::string& text) {
  std::ifstream file(std::filesystem::path(MRROC_SOURCE_DIR) / "src/canopen/cia402.eds");
  std::string eds{std::istreambuf_iterator<char>(file), {}};
  if (eds.find(found) == std::string::npos) throw std::invalid_argument(found);
  return canopen::EdsFile::parse(eds.replace(eds.find(found), found.size(), text), "changed");
}

/// The bus of a test: its own hub, or the interface that MRROC_TEST_BUS names.
class TestBus {
 public:
  explicit TestBus(can::Hub::Disturbance fault = {}) {
    if (const char* const name = std::getenv("MRROC_TEST_BUS")) {
      name_ = name;
      return;
    }
    folder_ = std::make_unique<task_test::ScratchFolder>();
    hub_ = std::make_unique<can::Hub>(*folder_ / "can", std::move(fault));
    name_ = hub_->name();
  }
  const std::string& name() const { return name_; }
  std::unique_ptr<can::Bus> open() const { return can::open_bus(name_); }
  CanHardware::OpenBus opener() const {
    return [name = name_] { return can::open_bus(name); };
  }
  /// Whether frames pass through the test's own hub.
  bool is_hub() const { return hub_ != nullptr; }

 private:
  std::unique_ptr<task_test::ScratchFolder> folder_;
  std::unique_ptr<can::Hub> hub_;
  std::string name_;
};

/// With a node that is not there.
inline constexpr CanHardware::Timing kShortBoot{.timeout = 0.5, .boot_timeout = 2};

/// Simulated drives of a robot on a bus, with a plant model behind them, and their thread. Each SYNC is a tick of the
/// drives.
class Rack {
 public:
  Rack(const config::DriveTable& table, const RobotModel& model, const TestBus& bus, bool synchronised,
       double period = kCanPeriod, const config::IoTable& io = {})
      : bus_(bus.open()),
        plant_(model, period, synchronised),
        rack_(
            table, model.parameters(), period, *bus_, plant_,
            [this](Tick last, bool, std::int64_t) {
              tick_ = last + 1;
              return sim::DriveRack::Newest{tick_};
            },
            sim::DriveRack::Time::plant, {}, io),
        thread_([this] { rack_.serve(); }) {}
  ~Rack() {
    rack_.stop();
    thread_.join();
  }
  void with(const std::function<void(std::vector<sim::DriveNode>&)>& action) { rack_.with(action); }
  void with_io(const std::function<void(std::vector<sim::IoNode>&)>& action) { rack_.with_io(action); }
  /// Shafts of the plant, at rest between two ticks of the master.
  JointVector shafts() {
    JointVector shafts;
    rack_.with([this, &shafts](auto&) {
      HardwareInput input;
      plant_.read(tick_, input);
      shafts = input.motors;
    });
    return shafts;
  }
  std::uint64_t cycles() const { return rack_.cycles(); }

 private:
  std::unique_ptr<can::Bus> bus_;
  LoopbackHardware plant_;
  Tick tick_ = 0;
  sim::DriveRack rack_;
  std::thread thread_;
};

/// The driver without a servo, with its drives on a bus. All commands keep the drives at their positions.
struct HeldGantry {
  explicit HeldGantry(canopen::DriveMode mode = canopen::DriveMode::cyclic_position)
      : HeldGantry(table_for(Gantry{}.parameters(), mode)) {}
  /// The drives `there` are those on the bus.
  explicit HeldGantry(const config::DriveTable& wanted) : HeldGantry(wanted, wanted) {}
  HeldGantry(const config::DriveTable& wanted, const config::DriveTable& there, bool synchronised = true,
             can::Hub::Disturbance fault = {})
      : table(wanted), bus(std::move(fault)), rack(there, model, bus, true), synchronised_(synchronised) {
    connect();
  }
  /// A new run, after the end of the previous driver.
  void connect() {
    hardware.reset();
    hardware =
        std::make_unique<CanHardware>(table, model.parameters(), kCanPeriod, bus.opener(), timing, synchronised_);
  }
  void run(Tick ticks) {
    for (const Tick end = tick + ticks; tick < end; ++tick) {
      hardware->read(tick, input);
      hardware->set_points(input.motors, JointVector::Zero(4));
      hardware->write(tick, JointVector::Zero(4));
      if (after_tick) after_tick();
    }
  }
  /// The error of `open`, the code's text first; empty: the drives are in service.
  std::string refusal() {
    try {
      hardware->open();
    } catch (const HardwareError& error) {
      return std::string(describe(error.code())).append(": ").append(error.what());
    }
    return "";
  }

  Gantry model;
  config::DriveTable table;
  TestBus bus;
  Rack rack;
  std::unique_ptr<CanHardware> hardware;
  CanHardware::Timing timing = kTestTiming;  ///< of the next `connect`
  std::function<void()> after_tick;
  Tick tick = 0;
  HardwareInput input;

 private:
  bool synchronised_;
};

/// A robot whose servo drives it over the bus.
template <class Model>
struct CanRig {
  explicit CanRig(canopen::DriveMode mode, bool synchronised = true, can::Hub::Disturbance fault = {})
      : CanRig(table_for(Model{}.parameters(), mode), synchronised, std::move(fault)) {}

  CanRig(const config::DriveTable& drives, bool synchronised, can::Hub::Disturbance fault = {},
         const config::IoTable& io = {})
      : table(drives),
        bus(std::move(fault)),
        rack(table, model, bus, synchronised, kCanPeriod, io),
        hardware(table, model.parameters(), kCanPeriod, bus.opener(), kTestTiming, synchronised, io) {
    hardware.open();
    effector.enable(true);
    while (!seen().enabled() && seen().fault.code == ErrorCode::none && now < 3000) tick();
  }

  void tick() {
    servo.tick(now++);
    Reply reply;
    while (effector.poll(reply)) replies.push_back(reply);
  }
  void run(Tick ticks) {
    for (Tick i = 0; i < ticks; ++i) tick();
  }
  bool send(const RobotCommand& command) { return effector.accept(command, ++number, answer); }
  const Snapshot& seen() const { return servo.snapshot(); }

  Model model;
  config::DriveTable table;
  TestBus bus;
  Rack rack;
  CanHardware hardware;
  ServoChannel hand_over;
  ModelSet models{model};
  clock::EmergencyStop operators;
  Servo servo{models, hardware, kCanPeriod, hand_over};
  Effector effector{models, kCanPeriod, hand_over};
  Tick now = 0;
  std::uint64_t number = 0;
  Reply answer;
  std::vector<Reply> replies;
};

inline RobotCommand relative_joints(const JointVector& way, std::uint16_t steps) {
  RobotCommand command;
  command.kind = CommandKind::joint;
  command.relative = true;
  command.joints = way;
  command.motion_steps = command.reply_step = steps;
  return command;
}

}  // namespace mrroc::edp
