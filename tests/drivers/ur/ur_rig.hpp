#pragma once

#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <optional>

#include "clock/wall/monotonic.hpp"
#include "drivers/ur/controller.hpp"
#include "edp/servo/robot_ticker.hpp"

namespace mrroc::ur {

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
    const edp::RobotTicker::Place place = ticker->wait_next();
    now = place.tick;
    input.time = place.measured;
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
