#pragma once

#include <atomic>
#include <thread>

#include "clock/clock.hpp"
#include "clock/ticker.hpp"
#include "edp/servo.hpp"

namespace mrroc::edp {

/// Real time: the thread that ticks a servo once per period on the deployment's grid, and wakes the comms thread when a
/// reply may leave. It inherits the real-time class of the thread that starts it.
class ServoThread {
 public:
  /// After `clock.start()`: the grid is known then.
  ServoThread(Servo& servo, clock::Clock& clock);
  /// Ends after the tick under way.
  ~ServoThread();
  ServoThread(const ServoThread&) = delete;
  ServoThread& operator=(const ServoThread&) = delete;

  /// Times and counts of its ticks. Any thread.
  const clock::Ticker& ticker() const noexcept { return ticker_; }

 private:
  void run() noexcept;

  Servo& servo_;
  clock::Clock& clock_;
  clock::Ticker ticker_;
  std::atomic<bool> ended_{false};
  std::thread thread_;
};

}  // namespace mrroc::edp
