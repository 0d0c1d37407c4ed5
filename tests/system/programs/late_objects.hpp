#pragma once

#include <exception>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <thread>

#include "mrroc/conditions/elapsed_steps.hpp"
#include "mrroc/message.hpp"
#include "mrroc/move.hpp"
#include "mrroc/robots/conveyor.hpp"
#include "mrroc/sensor.hpp"
#include "process/task_process.hpp"
#include "require.hpp"

namespace mrroc::test {

/// A behaviour that makes a sensor.
struct Make {
  int unused = 0;
};
MRROC_MESSAGE(Make, unused)

/// Makes robots and sensors while the task runs, selected by the name of the deployment. A deployment whose name starts
/// with "second" has a robot and a sensor from the start.
class LateObjects {
 public:
  LateObjects(process::TaskProcess& task, std::string robot) : task_(task), robot_(std::move(robot)) {
    if (!kind().starts_with("second")) return;
    belt_.emplace(task_, robot_);
    clock_.emplace(task_, "clock", "time");
  }

  const std::string& kind() const { return task_.process().deployment().name; }

  void make() {
    const std::map<std::string, std::function<void()>> kinds{
        {"sensor", [this] { use_sensor("clock"); }},
        {"published_sensor", [this] { use_sensor("published"); }},
        {"robot", [this] { use_robot(); }},
        {"sensor_in_thread", [this] { in_thread([this] { use_sensor("clock"); }); }},
        {"robot_in_thread", [this] { in_thread([this] { use_robot(); }); }},
        {"sensor_later",
         [this] {
           task_.sleep_until(task_.tick() + 100);
           use_sensor("clock");
         }},
        {"second_sensor", [this] { use_sensor("clock"); }},
        {"second_robot", [this] { use_robot(); }},
        {"second_of_another_sensor", [this] { use_sensor("published"); }},
        {"second_caught", [this] { go_on(); }}};
    kinds.at(kind())();
  }

  void use_sensor(const std::string& name) {
    Sensor sensor(task_, name, "time");
    Wait({}, {sensor}, ElapsedSteps{3});
    require(sensor.reading().tick > 0, "no reading");
  }

 private:
  void use_robot() {
    Conveyor belt(task_, robot_);
    Wait({belt}, {}, ElapsedSteps{3});
    require(belt.state().tick > 0, "no state");
  }

  /// The task may catch a refusal, and its initial objects still work.
  void go_on() {
    bool refused = false;
    try {
      use_sensor("published");
    } catch (const NonFatalError& error) {
      refused = error.code() == ErrorCode::invalid_argument;
    }
    require(refused, "it was not refused");
    Wait({*belt_}, {*clock_}, ElapsedSteps{3});
    require(clock_->reading().tick > 0, "no reading");
  }

  static void in_thread(const std::function<void()>& body) {
    std::exception_ptr error;
    std::thread([&] {
      try {
        body();
      } catch (...) {
        error = std::current_exception();
      }
    }).join();
    if (error) std::rethrow_exception(error);
  }

  process::TaskProcess& task_;
  std::string robot_;
  std::optional<Conveyor> belt_;
  std::optional<Sensor> clock_;
};

}  // namespace mrroc::test
