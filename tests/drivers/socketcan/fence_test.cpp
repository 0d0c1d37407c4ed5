// Lockstep: what a cycle contains does not depend on the time that simulated drives take.
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <string>
#include <thread>
#include <utility>

#include "can_rig.hpp"

namespace mrroc::edp {
namespace {

constexpr double kFar = 1000;  // s: a test that waits so long fails by its own timeout

config::DriveTable strict_table() {
  config::DriveTable table = table_for(Gantry{}.parameters(), canopen::DriveMode::cyclic_position);
  table.missed_max = 0;
  return table;
}

/// A bus on which another node sends `frames` more in front of each returned fence.
class BusyBus : public can::Bus {
 public:
  BusyBus(std::unique_ptr<can::Bus> bus, int frames) : bus_(std::move(bus)), frames_(frames) {}
  can::Sent send(const can::Frame& frame) noexcept override { return bus_->send(frame); }
  bool receive(can::Frame& frame, std::int64_t deadline) noexcept override {
    if (left_ > 0) {
      frame = --left_ > 0 ? can::Frame{0x1ff, {}} : fence_;
      return true;
    }
    if (!bus_->receive(frame, deadline)) return false;
    if (frames_ == 0 || !can::fence_of(frame, can::kReturnedFence)) return true;
    fence_ = std::exchange(frame, can::Frame{0x1ff, {}});
    left_ = frames_;
    return true;
  }
  void filter(std::span<const can::Filter> filters) override { bus_->filter(filters); }
  bool carries_fd() const noexcept override { return bus_->carries_fd(); }
  int descriptor() const noexcept override { return bus_->descriptor(); }

 private:
  std::unique_ptr<can::Bus> bus_;
  int frames_;
  int left_ = 0;
  can::Frame fence_;
};

/// The driver in lockstep, without a servo.
struct Fenced {
  explicit Fenced(double timeout = kFar, int other_frames = 0)
      : hardware(
            table, model.parameters(), kCanPeriod,
            [this, other_frames] { return std::make_unique<BusyBus>(bus.open(), other_frames); },
            {timeout, false, true}, true) {}
  void run(Tick ticks) {
    for (const Tick end = tick + ticks; tick < end; ++tick) {
      hardware.read(tick, input);
      hardware.set_points(input.motors, JointVector::Zero(4));
      hardware.write(tick, JointVector::Zero(4));
    }
  }

  Gantry model;
  config::DriveTable table = strict_table();
  TestBus bus;
  Rack rack{table, model, bus, true};
  CanHardware hardware;
  HardwareInput input;
  Tick tick = 1;
};

std::string text_of(const Fenced& fenced) { return std::string(describe(fenced.input.fault_detail).view()); }

/// Delays a rack again and again until its own destruction.
class Brake {
 public:
  explicit Brake(Rack& rack)
      : thread_([this, &rack] {
          while (!done_) rack.with([](auto&) { std::this_thread::sleep_for(std::chrono::milliseconds(20)); });
        }) {}
  ~Brake() {
    done_ = true;
    thread_.join();
  }
  Brake(const Brake&) = delete;
  Brake& operator=(const Brake&) = delete;

 private:
  std::atomic<bool> done_{false};
  std::thread thread_;
};

TEST(Fence, SlowDrivesAnswerInTheirCycle) {
  Fenced fenced;
  fenced.hardware.open();
  const Brake brake(fenced.rack);
  for (int i = 0; i < 5; ++i) {
    fenced.run(1);
    ASSERT_EQ(fenced.input.fault, ErrorCode::none) << text_of(fenced);
    EXPECT_EQ(fenced.input.time, static_cast<double>(fenced.tick - 1));
  }
}

TEST(Fence, EachTickIsOneCycleOfTheDrives) {
  Fenced fenced;
  fenced.hardware.open();
  const std::uint64_t begin = fenced.rack.cycles();
  fenced.run(50);
  EXPECT_EQ(fenced.rack.cycles(), begin + 50);
}

TEST(Fence, SilentDriveIsReportedWithoutATimeout) {
  Fenced fenced;
  fenced.hardware.open();
  fenced.run(5);
  fenced.rack.with([](auto& nodes) { nodes[2].cut(true); });
  fenced.run(1);
  EXPECT_EQ(fenced.input.fault, ErrorCode::hardware_silent);
  EXPECT_EQ(fenced.input.fault_axis, 2);
}

TEST(Fence, DrivesThatDoNotReturnItAreLostUntilTheReset) {
  Fenced fenced(0.1);
  fenced.hardware.open();
  fenced.run(5);
  fenced.rack.with([&fenced](auto&) { fenced.run(1); });
  EXPECT_EQ(fenced.input.fault, ErrorCode::hardware_silent);
  EXPECT_EQ(fenced.input.fault_axis, -1);
  EXPECT_NE(text_of(fenced).find("within 0.1 s of wall time"), std::string::npos);
  fenced.run(1);
  EXPECT_EQ(fenced.input.fault, ErrorCode::hardware_silent) << "it lasts";
  fenced.hardware.reset_fault();
  for (int i = 0; i < 1000 && (fenced.hardware.busy() || fenced.input.fault != ErrorCode::none); ++i) fenced.run(1);
  EXPECT_EQ(fenced.input.fault, ErrorCode::none) << text_of(fenced);
}

TEST(Fence, FramesOfOtherNodesDoNotEndTheWait) {
  for (const int frames : {1, 9999, 10000, 100000}) {
    Fenced fenced(kFar, frames);
    fenced.hardware.open();
    fenced.run(5);
    EXPECT_EQ(fenced.input.fault, ErrorCode::none) << frames << ": " << text_of(fenced);
  }
}

TEST(Fence, DrivesReturnThoseOfTheirMasterAlone) {
  const TestBus bus;
  const Gantry model;
  const Rack rack(strict_table(), model, bus, true);
  const auto master = bus.open();
  const std::array<can::Filter, 1> returned{can::Filter{can::kReturnedFence}};
  master->filter(returned);
  for (const std::uint8_t number : {std::uint8_t{126}, std::uint8_t{127}})
    master->send(can::to_frame({number, true, 7}, can::kFence));
  can::Frame frame;
  ASSERT_TRUE(master->receive(frame, INT64_MAX));
  EXPECT_EQ(can::fence_of(frame, can::kReturnedFence), (can::Fence{127, true, 7}));
}

}  // namespace
}  // namespace mrroc::edp
