#include "edp/servo_thread.hpp"

#include <cmath>

namespace mrroc::edp {

ServoThread::ServoThread(Servo& servo, clock::Clock& clock)
    : servo_(servo),
      clock_(clock),
      ticker_(clock.epoch_ns(), std::llround(clock.period() * 1e9)),
      thread_([this] { run(); }) {}

ServoThread::~ServoThread() {
  ended_ = true;
  thread_.join();
}

void ServoThread::run() noexcept {
  while (!ended_.load(std::memory_order_relaxed)) {
    if (servo_.tick(ticker_.wait_next())) clock_.notify();
  }
}

}  // namespace mrroc::edp
