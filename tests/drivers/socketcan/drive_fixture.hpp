#pragma once

#include <gtest/gtest.h>

#include <optional>

#include "can_rig.hpp"
#include "edp/safety/error_report.hpp"

namespace mrroc::edp {

using namespace canopen;

/// The report of a fault at tick 7.
inline std::string text_of(const DriveFault& fault) {
  return std::string(make_report(Fault{code_of(fault), 0, describe(fault), 7}, Slide{}.parameters()).detail.view());
}

/// A drive whose answers the test sets.
class DriveTest : public testing::Test {
 protected:
  DriveTest() { drive.begin(0); }

  static can::Frame feedback(std::uint16_t statusword, std::int32_t position, std::int16_t torque = 0) {
    can::Frame frame{0x181, {0, 0, 0, 0, 0, 0, 0, 0}};
    can::put(frame.data, 0, 2, statusword);
    can::put(frame.data, 2, 4, static_cast<std::uint32_t>(position));
    can::put(frame.data, 6, 2, static_cast<std::uint16_t>(torque));
    return frame;
  }
  void say(std::uint16_t statusword, std::int32_t position = 0, std::int16_t torque = 0) {
    cycle(feedback(statusword, position, torque));
  }
  void cycle(const can::Frame& frame) {
    drive.expect();
    can::Frame next;
    EXPECT_TRUE(drive.take(frame, ++tick, next));
    if (tells_switches) drive.take({0x281, {0, 0, 0, 0, 0, 0, 0, 0}}, tick, next);
    if (beats) drive.take(heartbeat_frame(1, NmtState::operational), tick, next);
    drive.close_cycle();
    answer_mode();
  }
  /// Its answer to the request for its mode.
  void answer_mode() {
    can::Frame question, next;
    if (!drive.asks(tick, question)) return;
    ++questions;
    EXPECT_EQ(question, (can::Frame{0x601, {0x40, 0x61, 0x60, 0, 0, 0, 0, 0}}));
    if (!answers) return;
    const std::uint8_t shown = told_mode ? static_cast<std::uint8_t>(*told_mode) : drive.command({}).data[6];
    drive.take(has_display ? can::Frame{0x581, {0x4f, 0x61, 0x60, 0, shown, 0, 0, 0}}
                           : can::Frame{0x581, {0x80, 0x61, 0x60, 0, 0, 0, 0x02, 0x06}},
               tick, next);
    EXPECT_EQ(next.size, 0);
  }
  void say_nothing() {
    drive.expect();
    ++tick;
    drive.close_cycle();
  }
  /// The state after the end of the cycle.
  void say_late(std::int32_t position) {
    say_nothing();
    can::Frame next;
    drive.take(feedback(status_bits(DriveState::operation_enabled), position), tick, next);
  }
  std::uint16_t controlword() { return static_cast<std::uint16_t>(can::get(drive.command({}).bytes(), 0, 2)); }
  void switch_on() {
    drive.enable(true, tick);
    say(status_bits(DriveState::operation_enabled));
  }

  config::DriveTable table = table_for(Slide{}.parameters(), DriveMode::cyclic_position);
  Drive drive{table, table.drives[0], kCanPeriod, 0};
  Tick tick = 0;
  bool tells_switches = true;
  bool beats = false;  ///< it also sends a heartbeat with every answer
  // the answer to the request for its mode
  bool answers = true, has_display = true;
  std::optional<int> told_mode;  ///< else the commanded mode
  int questions = 0;
};

}  // namespace mrroc::edp
