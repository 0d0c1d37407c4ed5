// Measurement times of the drives' readings: the servo reads a bus at its own ticks.
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <thread>

#include "can_rig.hpp"

namespace mrroc::edp {
namespace {

/// A plant whose shafts turn by kWay in each of its ticks, independent of the drives.
class Turning final : public Hardware {
 public:
  static constexpr double kWay = 0.25;
  void open() override {}
  void enable(bool) noexcept override {}
  void read(Tick tick, HardwareInput& input) noexcept override {
    input.motors.setConstant(4, kWay * static_cast<double>(tick));
    input.current.setZero(4);
  }
  void write(Tick, const JointVector&) noexcept override {}
  void set_origin(const JointVector&) noexcept override {}
};

/// A robot's drives over such a plant, with measurements that are `age` servo periods old.
class TurningRig {
 public:
  explicit TurningRig(bool real)
      : hardware_(table_, model_.parameters(), kCanPeriod, bus_.opener(), {kTestTiming.timeout, real}, true),
        thread_([this] { rack_.serve(); }) {
    hardware_.open();
    ear_ = bus_.open();
  }
  ~TurningRig() {
    rack_.stop();
    thread_.join();
  }
  HardwareInput read(Tick tick) {
    HardwareInput input;
    input.time = static_cast<double>(tick);
    hardware_.read(tick, input);
    hardware_.write(tick, JointVector::Zero(4));
    return input;
  }
  /// The first drive's wire.
  void cut(bool on) {
    rack_.with([on](auto& nodes) { nodes[0].cut(on); });
  }
  /// Its answers come after the driver has stopped waiting for them.
  void lag(bool on) {
    rack_.with([on](auto& nodes) { nodes[0].lag(on); });
  }
  /// The first drive's next answer, as an earlier participant of the bus receives it.
  void await_answer() {
    can::Frame frame;
    while (frame.id != canopen::kTransmitPdo1 + 1) ASSERT_TRUE(ear_->receive(frame, INT64_MAX));
  }
  std::atomic<double> age{0};

 private:
  const Gantry model_;
  const config::DriveTable table_ = table_for(model_.parameters(), canopen::DriveMode::cyclic_position);
  const TestBus bus_;
  const std::unique_ptr<can::Bus> rack_bus_ = bus_.open();
  Turning plant_;
  sim::DriveRack rack_{table_,
                       model_.parameters(),
                       kCanPeriod,
                       *rack_bus_,
                       plant_,
                       [this](Tick last, bool, std::int64_t) {
                         return sim::DriveRack::Newest{last + 1, age.load()};
                       },
                       sim::DriveRack::Time::plant};
  CanHardware hardware_;
  std::unique_ptr<can::Bus> ear_;
  std::thread thread_;
};

TEST(Timing, ReadingIsAsLateAsItsAnswer) {
  TurningRig rig(true);
  rig.read(100);
  std::this_thread::sleep_for(std::chrono::duration<double>(5 * kCanPeriod));
  EXPECT_GE(rig.read(101).late, 4);
  std::this_thread::sleep_for(std::chrono::duration<double>(3 * kCanPeriod));
  EXPECT_GE(rig.read(102).late, 6);
}

TEST(Timing, NothingIsLateInLockstep) {
  TurningRig rig(false);
  for (Tick tick = 7; tick < 12; ++tick) EXPECT_EQ(rig.read(tick).late, 0);
}

TEST(Timing, ExtrapolatedOrPossiblyOldReadingIsOfNoNewTick) {
  TurningRig rig(false);
  for (Tick tick = 1; tick < 5; ++tick) EXPECT_EQ(rig.read(tick).time, tick);
  rig.cut(true);
  EXPECT_EQ(rig.read(5).time, 4) << "guessed";
  rig.cut(false);
  EXPECT_EQ(rig.read(6).time, 4) << "it may be the answer to the SYNC before";
  EXPECT_EQ(rig.read(7).time, 7);
}

TEST(Timing, DriveThatAlwaysAnswersTooLateIsSilent) {
  TurningRig rig(false);
  rig.lag(true);
  for (Tick tick = 1; tick <= 2; ++tick) {
    EXPECT_EQ(rig.read(tick).fault, ErrorCode::none) << tick;
    rig.await_answer();
  }
  const HardwareInput input = rig.read(3);
  EXPECT_EQ(input.fault, ErrorCode::hardware_silent);
  EXPECT_EQ(input.fault_axis, 0);
  EXPECT_EQ(describe(input.fault_detail), describe(DriveFault(Silent{Silent::How::late, 2})));
  rig.await_answer();
  rig.lag(false);
  EXPECT_EQ(rig.read(4).fault, ErrorCode::none);
}

TEST(Timing, SimulatedDrivesMeasureAtTheSync) {
  TurningRig rig(false);
  const double increment = 2 * std::numbers::pi / 4000;
  for (const double age : {0.0, 0.5, 0.9, -0.5, 2.0, 7.0, 30.0}) {
    rig.age.store(0);
    const double there = rig.read(1).motors[0];
    rig.age.store(age);
    const double way = rig.read(1).motors[0] - there;
    EXPECT_NEAR(way, Turning::kWay * (1 + std::min(age, 10.0)), 2 * increment) << age;
  }
}

}  // namespace
}  // namespace mrroc::edp
