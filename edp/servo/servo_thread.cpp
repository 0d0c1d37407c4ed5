#include "edp/servo/servo_thread.hpp"

#include <pthread.h>

#include <cmath>

#include "clock/wall/realtime.hpp"

namespace mrroc::edp {
namespace {

void raise_priority() noexcept {
  int policy = 0;
  sched_param parameters{};
  if (pthread_getschedparam(pthread_self(), &policy, &parameters) != 0) return;
  if (policy == SCHED_OTHER) clock::take_short_slice();
  if (policy != SCHED_FIFO) return;
  if (parameters.sched_priority >= sched_get_priority_max(SCHED_FIFO)) return;
  ++parameters.sched_priority;
  pthread_setschedparam(pthread_self(), policy, &parameters);  // on failure the inherited priority stays
}

}  // namespace

ServoThread::ServoThread(Servo& servo, clock::Clock& clock, Tick notify_every)
    : servo_(servo),
      clock_(clock),
      notify_every_(notify_every),
      ticker_(clock.epoch_ns(), std::llround(clock.period() * 1e9)) {
  if (RobotClock* const robot = servo.robot_clock()) robot_ticker_.emplace(*robot, clock.epoch_ns(), clock.period());
  thread_ = std::thread([this] { run(); });
}

ServoThread::~ServoThread() {
  end_.store(true, std::memory_order_release);
  thread_.join();
}

void ServoThread::run() noexcept {
  raise_priority();
  robot_ticker_ ? follow_robot() : follow_grid();
}

void ServoThread::follow_grid() noexcept {
  Tick next = 0;
  for (;;) {
    const Tick present = ticker_.wait_next();
    if (next == 0 || !servo_.drives_wait()) next = present;
    for (; next <= present; ++next)
      if (!tick({next, 0, static_cast<double>(next)})) return;
  }
}

void ServoThread::follow_robot() noexcept {
  for (;;) {
    if (!tick(robot_ticker_->wait_next())) return;
  }
}

/// False: the robot has stopped for the end.
bool ServoThread::tick(RobotTicker::Place place) noexcept {
  const bool ending = end_.load(std::memory_order_acquire);
  if (ending) servo_.leave();
  const bool forward = notify_every_ != 0 && place.tick % notify_every_ == 0;
  if (servo_.tick(place.tick, place.ahead, place.measured) || forward) clock_.notify();
  return !ending || servo_.drives_on();
}

}  // namespace mrroc::edp
