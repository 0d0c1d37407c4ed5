#pragma once

#include <cstdint>
#include <cstdio>
#include <string>

#include "mrroc/conditions/elapsed_steps.hpp"
#include "mrroc/move.hpp"
#include "process/task_process.hpp"
#include "require.hpp"

namespace mrroc::test {

/// Steps of each of the three instructions in which a client reads its sensors.
inline constexpr std::uint64_t kClientSteps = 30;

/// One of the processes that use the sensors "shared" and "free" of any type at the same time. In a deployment named
/// "hold" it reads them in an endless loop.
class Client {
 public:
  explicit Client(process::TaskProcess& task)
      : task_(task), shared_(task, "shared", type(0)), free_(task, "free", type(1)) {}

  /// Takes a new reading of "shared" every `period` steps, of "free" at each; after instruction number `bias_after` it
  /// sets the present value as zero and prints it.
  void run(const RobotList& robots, std::uint32_t period, int bias_after) {
    shared_.set_period(period);
    for (int i = 1; i <= 3; ++i) {
      check(robots);
      if (i == bias_after) bias();
    }
  }

 private:
  const std::string& type(std::size_t sensor) const { return task_.process().deployment().sensors.at(sensor).type; }

  void check(const RobotList& robots) {
    const bool hold = task_.process().deployment().name == "hold";
    const When seen("seen", [this] {
      check(shared_, last_shared_);
      check(free_, last_free_);
      return false;
    });
    std::printf("looks\n");
    std::fflush(stdout);  // the test waits for it
    if (hold) Wait(robots, {shared_, free_}, seen);
    Wait(robots, {shared_, free_}, seen || ElapsedSteps{kClientSteps});
  }

  /// A reading equals the previous one, or is later and has a higher number.
  static void check(const Sensor& sensor, SensorReading& last) {
    const SensorReading& now = sensor.reading();
    const bool same = now.sequence == last.sequence && now.tick == last.tick;
    require(same || (now.sequence > last.sequence && now.tick >= last.tick), sensor.name() + " mixes up its readings");
    last = now;
  }

  void bias() {
    shared_.bias();
    require(shared_.value(0) == 0, "its zero was not set");
    std::printf("zero at %.0f\n", shared_.value(1));
  }

  process::TaskProcess& task_;
  Sensor shared_, free_;
  SensorReading last_shared_, last_free_;
};

}  // namespace mrroc::test
