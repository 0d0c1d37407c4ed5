#pragma once

#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <optional>

#include "clock/wall/monotonic.hpp"
#include "drivers/ur/six_joints.hpp"
#include "drivers/ur/ur_hardware.hpp"
#include "edp/servo/robot_ticker.hpp"
#include "sim/ur/controller_servers.hpp"

namespace mrroc::ur {

using sim::ur::ControllerServers;
using sim::ur::ExactJoints;
using sim::ur::Six;
using sim::ur::VirtualController;
using Interface = DriveParameters::Interface;

inline constexpr double kPeriod = 0.002;
inline constexpr double kGear = 100;

inline ControllerServers::Options free_ports() {
  ControllerServers::Options options;
  options.rtde_port = options.dashboard_port = options.primary_port = options.secondary_port = options.realtime_port =
      0;
  options.controller.unlock_delay = 0.2;
  return options;
}

/// A simulated controller on free ports.
class Controller {
 public:
  explicit Controller(const ControllerServers::Options& options = free_ports())
      : servers(options, std::make_unique<ExactJoints>(Six{0, -1.5, 1.5, -1.5, -1.5, 0})) {}

  UrOptions driver_options() const {
    UrOptions options;
    options.address = "127.0.0.1";
    options.rtde_port = servers.ports().rtde;
    options.dashboard_port = servers.ports().dashboard;
    options.script_port = servers.ports().secondary;
    options.script = MRROC_SOURCE_DIR "/drivers/ur/control.script";
    options.watchdog = 1;  // of a busy machine's test
    options.missed_max = 250;
    return options;
  }

  /// A value of the controller between two of its periods.
  template <class Get>
  auto ask(Get get) {
    decltype(get(std::declval<VirtualController&>())) value{};
    servers.with([&](VirtualController& controller) { value = get(controller); });
    return value;
  }

  ControllerServers servers;
};

/// The driver with a servo that ticks with the controller. Nothing here depends on how long a tick takes: conditions
/// are awaited, and a condition that never holds fails the test.
class Rig {
 public:
  explicit Rig(Interface interface = Interface::position,
               const ControllerServers::Options& controller_options = free_ports(),
               const std::function<void(UrOptions&)>& change = {})
      : controller(controller_options), model(interface) {
    UrOptions options = controller.driver_options();
    if (change) change(options);
    hardware = std::make_unique<UrHardware>(options, model, kPeriod);
    hardware->open();
    ticker.emplace(*hardware->clock(), clock::monotonic_ns(), kPeriod);
    set = JointVector::Zero(6);
    tick();
    set = input.motors;
  }

  /// One tick of a servo: it commands `set` moving with `rate` once it is on.
  void tick() {
    const auto [present, ahead] = ticker->wait_next();
    now = present;
    input.time = static_cast<double>(present) + ahead;
    input.motors = JointVector::Constant(6, std::nan(""));
    input.fault_axis = -1;
    input.fault_detail = {};
    hardware->read(now, input);
    const bool on = enabled && !hardware->busy();
    if (!on && input.motors.size() == 6) set = input.motors;
    if (on) set += rate * kPeriod;
    hardware->set_points(set, rate);
    hardware->write(now, JointVector::Zero(6));
  }

  bool tick_until(const std::function<bool()>& condition) {
    for (int i = 0; i < kMostTicks; ++i) {
      tick();
      if (condition()) return true;
    }
    return false;
  }

  void ticks(int count) {
    for (int i = 0; i < count; ++i) tick();
  }

  void enable(bool on) {
    enabled = on;
    rate = JointVector::Zero(6);
    hardware->enable(on);
  }

  /// Until the servo commands the arm.
  ::testing::AssertionResult start() {
    enable(true);
    if (!tick_until([this] { return !hardware->busy(); })) return ::testing::AssertionFailure() << "it stays busy";
    return healthy();
  }

  ::testing::AssertionResult recover() {
    enabled = false;
    rate = JointVector::Zero(6);
    hardware->reset_fault();
    if (!tick_until([this] { return !hardware->busy(); })) return ::testing::AssertionFailure() << "it stays busy";
    return healthy() ? start() : healthy();
  }

  ::testing::AssertionResult healthy() const {
    if (input.fault == ErrorCode::none) return ::testing::AssertionSuccess();
    return ::testing::AssertionFailure() << describe(input.fault) << ": " << text();
  }

  bool finds(ErrorCode code) {
    return tick_until([this, code] { return input.fault == code; });
  }

  std::string text() const { return std::string(edp::describe(input.fault_detail).view()); }

  Six joints() {
    return controller.ask([](VirtualController& c) { return c.position(); });
  }

  Controller controller;
  SixJoints model;
  std::unique_ptr<UrHardware> hardware;
  std::optional<edp::RobotTicker> ticker;
  edp::HardwareInput input;
  JointVector set, rate = JointVector::Zero(6);  ///< set-points of the shafts
  Tick now = 0;
  bool enabled = false;

 private:
  static constexpr int kMostTicks = 20000;
};

}  // namespace mrroc::ur
