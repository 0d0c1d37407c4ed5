#include <gtest/gtest.h>
#include <stdlib.h>

#include <chrono>
#include <iostream>
#include <random>
#include <thread>

#include "bent_model.hpp"
#include "drivers/mujoco/mujoco_hardware.hpp"
#include "reference_dynamics.hpp"
#include "sim/simulation.hpp"
#include "worlds.hpp"

namespace mrroc::sim::real_time_test {
namespace {

using edp::HardwareInput;
using edp::MujocoHardware;

constexpr double kPeriod = 0.002;
constexpr double kImpatient = 5e-5;  // s
constexpr double kForEver = 100;     // s

/// A separate regulator for each arm: it pulls towards a wave, against gravity and a non-linear transmission.
JointVector currents(Tick tick, std::size_t robot, const HardwareInput& input) {
  JointVector wanted(2);
  const double phase = kPeriod * static_cast<double>(tick) + static_cast<double>(robot);
  wanted << 50 + 20 * std::sin(3 * phase), 60 + 20 * std::cos(2 * phase);
  return 0.05 * (wanted - input.motors);
}

class RealTime : public testing::Test {
 protected:
  RealTime() { setenv("MRROC_SHARE", kData.c_str(), 1); }
  world::JointMeasurement measurement(std::size_t robot) const {
    world::JointMeasurement value;
    EXPECT_TRUE(memory_->measurements[robot].load(value));
    return value;
  }
  BentModel model_;
  std::unique_ptr<world::WorldMemory> memory_ = std::make_unique<world::WorldMemory>();
};

/// Sleeps occasionally, for up to a millisecond, like a thread of a busy machine.
class Straggler {
 public:
  explicit Straggler(unsigned seed) : random_(seed) {}
  void operator()() {
    if (random_() % 8 == 0) std::this_thread::sleep_for(std::chrono::microseconds(random_() % 1000));
  }

 private:
  std::mt19937 random_;
};

constexpr Tick kTicks = 1500;

/// The positions of both arms over all ticks; `seed` 0: in lockstep, else in three threads with random delays.
std::vector<double> run(unsigned seed) {
  const BentModel model;
  const auto memory = std::make_unique<world::WorldMemory>();
  Simulation simulation(twolink_deployment(2), *memory);
  simulation.publish_initial();
  const auto timing = seed == 0 ? MujocoHardware::Timing::lockstep : MujocoHardware::Timing::real;
  MujocoHardware drives[2] = {{model, *memory, 0, timing, true, kForEver}, {model, *memory, 1, timing, true, kForEver}};
  std::vector<double> positions;
  const auto step = [&](Tick tick) {
    if (seed == 0)
      simulation.step(tick);
    else
      simulation.step_in_real_time(tick, kForEver);
    for (const std::size_t robot : {0U, 1U}) {
      world::JointMeasurement measured;
      EXPECT_TRUE(memory->measurements[robot].load(measured));
      positions.insert(positions.end(), measured.position.begin(), measured.position.begin() + 2);
    }
  };
  const auto serve = [&](std::size_t robot, Tick tick) {
    HardwareInput input;
    drives[robot].read(tick, input);
    EXPECT_EQ(input.fault, ErrorCode::none);
    drives[robot].write(tick, currents(tick, robot, input));
  };
  for (MujocoHardware& each : drives) each.enable(true);
  step(1);
  for (const std::size_t robot : {0U, 1U}) serve(robot, 1);  // from here on no thread may run ahead
  if (seed == 0) {
    for (Tick tick = 2; tick <= kTicks; ++tick) {
      step(tick);
      for (const std::size_t robot : {0U, 1U}) serve(robot, tick);
    }
    return positions;
  }
  std::vector<std::thread> threads;
  for (const std::size_t robot : {0U, 1U}) {
    threads.emplace_back([&, robot] {
      Straggler straggle(seed + static_cast<unsigned>(robot));
      for (Tick tick = 2; tick <= kTicks; ++tick, straggle()) serve(robot, tick);
    });
  }
  Straggler straggle(seed + 7);
  for (Tick tick = 2; tick <= kTicks; ++tick, straggle()) step(tick);
  for (std::thread& thread : threads) thread.join();
  return positions;
}

TEST_F(RealTime, WorldMovesAsInLockstepWithAnyDelayOfItsParts) {
  const std::vector<double> lockstep = run(0);
  double least = lockstep[0], most = lockstep[0];
  for (std::size_t i = 0; i < lockstep.size(); i += 4) {
    least = std::min(least, lockstep[i]);
    most = std::max(most, lockstep[i]);
  }
  EXPECT_GT(most - least, 0.2) << "the arms must move";
  for (unsigned seed = 1; seed <= 3; ++seed) {
    std::cout << "seed " << seed << "\n";
    EXPECT_EQ(run(seed), lockstep);
  }
}

TEST_F(RealTime, RobotThatDelaysTheWorldIsBrakedUntilItDrivesAgain) {
  Simulation simulation(twolink_deployment(1), *memory_);
  simulation.publish_initial();
  MujocoHardware drives(model_, *memory_, 0, MujocoHardware::Timing::real, true, kImpatient);
  const auto moves_in = [&](Tick tick) {
    const double before = measurement(0).position[0];
    simulation.step_in_real_time(tick, kImpatient);
    return measurement(0).position[0] != before;
  };
  const auto drive = [&](Tick tick) {
    HardwareInput input;
    drives.read(tick, input);
    EXPECT_EQ(input.fault, ErrorCode::none);
    drives.write(tick, JointVector::Zero(2));
  };
  drives.enable(true);
  EXPECT_FALSE(moves_in(1)) << "never driven";
  drive(1);
  EXPECT_TRUE(moves_in(2));
  EXPECT_FALSE(moves_in(3)) << "waited for until the timeout";
  EXPECT_FALSE(moves_in(4));
  drive(2);  // late; the world is ahead of it
  EXPECT_FALSE(moves_in(5)) << "waited for again";
  drive(5);
  EXPECT_TRUE(moves_in(6));
}

TEST_F(RealTime, RobotThatStopsDrivingDoesNotStopTheOthers) {
  Simulation simulation(twolink_deployment(2), *memory_);
  simulation.publish_initial();
  MujocoHardware stalled(model_, *memory_, 0, MujocoHardware::Timing::real);
  MujocoHardware well(model_, *memory_, 1, MujocoHardware::Timing::real, true, kForEver);
  HardwareInput input;
  for (MujocoHardware* drives : {&stalled, &well}) {
    drives->enable(true);
    drives->read(0, input);
    drives->write(1, JointVector::Zero(2));
  }
  std::thread servo([&] {
    for (Tick tick = 2; tick <= 20; ++tick) {
      well.read(tick, input);
      EXPECT_EQ(input.fault, ErrorCode::none) << tick;
      well.write(tick, JointVector::Zero(2));
    }
  });
  double before = 0;
  for (Tick tick = 2; tick <= 20; ++tick) {
    // long enough for the working servo, too short for the other
    simulation.step_in_real_time(tick, tick == 3 ? 0.05 : kForEver);
    if (tick > 3) {
      EXPECT_EQ(measurement(0).position[0], before) << "braked";
    }
    before = measurement(0).position[0];
  }
  servo.join();
}

TEST_F(RealTime, SilentWorldIsReportedUntilItContinues) {
  Simulation simulation(twolink_deployment(1), *memory_);
  MujocoHardware drives(model_, *memory_, 0, MujocoHardware::Timing::real, true, kImpatient);
  HardwareInput input;
  drives.read(0, input);
  EXPECT_EQ(input.fault, ErrorCode::hardware_silent) << "nothing measured yet";
  simulation.publish_initial();
  drives.read(0, input);
  EXPECT_EQ(input.fault, ErrorCode::none);
  drives.read(1, input);
  EXPECT_EQ(input.fault, ErrorCode::hardware_silent);
  const JointVector known = input.motors;
  EXPECT_EQ(known.size(), 2) << "the last known motors";
  for (Tick tick = 1; tick <= 9; ++tick) simulation.step_in_real_time(tick, kImpatient);
  for (const Tick tick : {Tick{2}, Tick{9}}) {
    drives.read(tick, input);
    EXPECT_EQ(input.fault, ErrorCode::none) << "a world that has continued without the robot is not a fault";
  }
}

}  // namespace
}  // namespace mrroc::sim::real_time_test
