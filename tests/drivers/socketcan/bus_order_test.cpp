#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <set>
#include <thread>
#include <vector>

#include "can_rig.hpp"

namespace mrroc::edp {
namespace {

using namespace canopen;

/// Drives that are on, and all frames on their bus since the set-up.
struct HeardGantry : HeldGantry {
  explicit HeardGantry(const config::DriveTable& wanted, can::Hub::Disturbance fault = {})
      : HeldGantry(wanted, wanted, true, std::move(fault)) {
    hardware->open();
    ear = bus.open();
    after_tick = [this] { listen(); };
    hardware->enable(true);
    run(20);
    EXPECT_FALSE(hardware->busy()) << "they are on";
  }
  void listen() {
    for (can::Frame frame; ear->receive(frame, 0);) heard.push_back(frame);
  }

  std::unique_ptr<can::Bus> ear;
  std::vector<can::Frame> heard;
};

config::DriveTable gantry_table() { return table_for(Gantry{}.parameters(), DriveMode::cyclic_position); }

/// An SDO answer may take long: it would come between the SYNC and the measurements.
TEST(BusOrder, SdoRequestFollowsTheAnswersToTheSync) {
  HeardGantry rig(gantry_table());
  rig.run(1000);
  std::set<std::uint32_t> answered;
  int questions = 0;
  for (const can::Frame& frame : rig.heard) {
    if (frame.id == kSync) answered.clear();
    if (frame.id > kTransmitPdo1 && frame.id <= kTransmitPdo1 + 4) answered.insert(frame.id);
    if (frame.id <= kSdoRequest || frame.id > kSdoRequest + 4) continue;
    if (can::get(frame.bytes(), 1, 2) != kModeDisplay.index) continue;
    ++questions;
    EXPECT_EQ(answered.size(), 4u) << "question " << questions;
  }
  EXPECT_GE(questions, 4);
}

TEST(BusOrder, DriveThatIgnoresAStopIsStoppedAgainBeforeTheNextHeartbeat) {
  std::atomic<bool> deaf{false};
  std::atomic<int> stops{0};
  config::DriveTable table = gantry_table();
  table.heartbeat = 10;
  HeardGantry rig(table, [&](can::Frame& frame) {
    const bool stop = frame == nmt_frame(NmtCommand::stop, 2);
    if (stop) ++stops;
    return !deaf || (!stop && frame.id != kReceivePdo1 + 2);
  });
  if (!rig.bus.is_hub()) return;  // the kernel cannot lose frames of one kind only
  deaf = true;
  rig.hardware->enable(false);
  rig.run(1000);  // 2 s: 0.5 s for the drive to obey, then a stop each 0.1 s
  EXPECT_GE(stops, 14);
  EXPECT_LE(stops, 16);
  rig.rack.with([](auto& nodes) { EXPECT_TRUE(nodes[1].powered()); });
  deaf = false;
  rig.run(60);
  rig.rack.with([](auto& nodes) { EXPECT_FALSE(nodes[1].powered()); });
}

/// Drives receive it with the quick stop: a drive that regulates until it stands would jump.
TEST(BusOrder, LastCommandHoldsThePositionOfTheDrive) {
  HeardGantry rig(gantry_table());
  JointVector target = rig.input.motors;
  for (int i = 0; i < 50; ++i) {
    rig.hardware->read(rig.tick, rig.input);
    target += JointVector::Constant(4, 0.05);
    rig.hardware->set_points(target, JointVector::Zero(4));
    rig.hardware->write(rig.tick++, JointVector::Zero(4));
    rig.listen();
  }
  rig.hardware->read(rig.tick, rig.input);
  rig.hardware.reset();
  const can::Frame last = nmt_frame(NmtCommand::enter_pre_operational, 4);
  for (int i = 0; i < 5000 && std::find(rig.heard.begin(), rig.heard.end(), last) == rig.heard.end(); ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    rig.listen();
  }
  for (NodeId node = 1; node <= 4; ++node) {
    const auto command = std::find_if(rig.heard.rbegin(), rig.heard.rend(),
                                      [node](const can::Frame& frame) { return frame.id == kReceivePdo1 + node; });
    ASSERT_NE(command, rig.heard.rend());
    const auto answer = std::find_if(command, rig.heard.rend(),
                                     [node](const can::Frame& frame) { return frame.id == kTransmitPdo1 + node; });
    ASSERT_NE(answer, rig.heard.rend());
    const auto position = [](const can::Frame& frame) { return can::sign_extended(can::get(frame.bytes(), 2, 4), 4); };
    EXPECT_EQ(can::get(command->bytes(), 0, 2), kQuickStop);
    EXPECT_EQ(position(*command), position(*answer));
    EXPECT_GT(std::abs(position(*answer)), 100) << "it has been moved";
  }
}

}  // namespace
}  // namespace mrroc::edp
