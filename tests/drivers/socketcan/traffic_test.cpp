// The figures of the load of a bus against the frames that the driver and its drives send.
#include "traffic.hpp"

#include <gtest/gtest.h>

#include "config/drives/bus_load.hpp"
#include "frame_length.hpp"

namespace mrroc::edp {
namespace {

TEST(BusTraffic, FrameLengthIsThatOfTheStandard) {
  // 44 bits and 3 between frames; id 555h has no run of five equal bits
  EXPECT_EQ(can::frame_length({0x555, {}}) / 10, 4);
  for (std::uint8_t size = 0; size <= 8; ++size) {
    can::Frame frame;
    frame.size = size;
    for (unsigned value = 0; value < 256; ++value) {
      frame.id = value * 8 + 7;
      frame.data.fill(static_cast<std::uint8_t>(value));
      EXPECT_GE(can::frame_length(frame), 47 + 8 * size);
      EXPECT_LE(can::frame_length(frame), config::frame_bits(size));
    }
  }
}

TEST(BusTraffic, LoadIsThatOfTheFramesOnTheBus) {
  using canopen::DriveMode;
  for (const DriveMode mode : {DriveMode::cyclic_position, DriveMode::cyclic_velocity, DriveMode::cyclic_torque})
    for (const int axes : {1, 3, 6}) {
      Traffic traffic(axes, mode);
      const int cycles = 10 * traffic.table().status_every;
      int bound = 0;
      for (int i = 0; i < cycles; ++i)
        for (const can::Frame& frame : traffic.cycle()) {
          bound += config::frame_bits(frame.size);
          EXPECT_LE(can::frame_length(frame), config::frame_bits(frame.size));
        }
      const config::BusLoad load = config::bus_load(traffic.table(), {}, kCanPeriod);
      const double heartbeats = (axes + 1) * config::frame_bits(1) / traffic.table().heartbeat;
      EXPECT_NEAR(bound, (load.per_second - heartbeats) * kCanPeriod * cycles, 1) << axes;
    }
}

}  // namespace
}  // namespace mrroc::edp
