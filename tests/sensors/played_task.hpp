#pragma once

#include <algorithm>
#include <string>

#include "mrroc/errors.hpp"
#include "mrroc/task.hpp"
#include "mrroc/testing/scratch_folder.hpp"
#include "vsp/replay_source.hpp"
#include "vsp/sampler.hpp"

namespace mrroc::vsp {

/// A task with one sensor, whose VSP runs in this process and replays `readings`: the sensor's own aggregating function
/// and sampler, without transport.
class PlayedTask : public Task, private SensorLink, private ReadingSink {
 public:
  /// `readings`: text of a replay file. `period` 0: interactive.
  PlayedTask(VirtualSensor& sensor, std::string type, const std::string& readings, Tick period = 0)
      : type_(std::move(type)),
        period_(period),
        source_(scratch_.write("played.txt", readings), sensor.raw_channels()),
        sampler_(sensor, source_, period) {}

  const std::string& process_name() const noexcept override { return name_; }
  std::string robot_name(const std::string& requested) const override { return requested; }
  RobotLink& robot_link(const std::string& name, const std::string& /*type*/) override {
    throw NonFatalError(ErrorCode::invalid_argument, "no robot " + name);
  }
  SensorLink& sensor_link(const std::string& name, const std::string& type, bool& interactive) override {
    if (type != type_) throw NonFatalError(ErrorCode::invalid_argument, name + " is not of type " + type);
    interactive = period_ == 0;
    return *this;
  }
  double servo_period() const noexcept override { return 0.002; }
  Tick tick() const noexcept override { return now_; }
  double wall_seconds() const noexcept override { return 0; }
  void sleep_until(Tick tick) override { run_until(tick); }
  OperatorRequest operator_request() noexcept override { return OperatorRequest::none; }
  bool take_trigger() noexcept override { return false; }
  StepObserver* observer() noexcept override { return nullptr; }

 private:
  void request(const SensorRequest& request) override {
    answered_ = false;
    sampler_.on_request({0, 1}, request, now_, *this);
  }
  void receive(SensorReading& reading) override {
    run_until(now_);
    while (!answered_) run_until(now_ + 1);
    reading = answer_;
  }
  bool latest(SensorReading& reading) override {
    run_until(now_);
    if (published_.sequence == 0) return false;
    reading = published_;
    return true;
  }
  void reply(const Caller& /*caller*/, const SensorReading& reading) override {
    answer_ = reading;
    answered_ = true;
  }
  void publish(const SensorReading& reading) override { published_ = reading; }

  void run_until(Tick tick) {
    while (sampler_.next_wake() <= tick) {
      now_ = std::max(now_, sampler_.next_wake());
      sampler_.on_tick(now_, *this);
    }
    now_ = std::max(now_, tick);
  }

  task_test::ScratchFolder scratch_;
  std::string name_ = "test";
  std::string type_;
  Tick period_;
  Tick now_ = 0;
  ReplaySource source_;
  Sampler sampler_;
  SensorReading answer_;
  SensorReading published_;
  bool answered_ = false;
};

}  // namespace mrroc::vsp
