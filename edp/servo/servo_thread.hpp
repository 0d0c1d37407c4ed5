#pragma once

#include <atomic>
#include <optional>
#include <thread>

#include "clock/clock.hpp"
#include "clock/wall/ticker.hpp"
#include "edp/servo/robot_ticker.hpp"
#include "edp/servo/servo.hpp"

namespace mrroc::edp {

/// Real time: the servo's own thread, ticking from construction to destruction on the deployment's grid, or beside it
/// with the packages of a robot that keeps the time (RobotTicker). When a tick puts out reports it wakes the comms
/// thread with `Clock::notify`. It inherits the scheduling class of the thread that makes it; under SCHED_FIFO it takes
/// the next higher priority, so that no comms thread of the process delays it, otherwise a short time slice, so that
/// threads with a longer one give way when it wakes. Ticks whose time has passed are skipped on drives that continue on
/// their own; drives that wait get all of them, late.
///
/// The destructor stops the robot, switches the drives off, and returns when that is done (a stop's duration).
class ServoThread {
 public:
  /// After `clock.start()`. `servo` and `clock` must outlive it; no other thread may tick `servo`. `notify_every`:
  /// ticks after which the comms thread is woken in any case, to forward the state; 0: never.
  ServoThread(Servo& servo, clock::Clock& clock, Tick notify_every = 0);
  ~ServoThread();
  ServoThread(const ServoThread&) = delete;
  ServoThread& operator=(const ServoThread&) = delete;

  /// Lateness, execution times, missed ticks. Any thread.
  const clock::TickStatistics& statistics() const noexcept {
    return robot_ticker_ ? robot_ticker_->statistics() : ticker_.statistics();
  }

 private:
  void run() noexcept;
  void follow_grid() noexcept;
  void follow_robot() noexcept;
  bool tick(RobotTicker::Place place) noexcept;

  Servo& servo_;
  clock::Clock& clock_;
  const Tick notify_every_;
  clock::Ticker ticker_;
  std::optional<RobotTicker> robot_ticker_;
  std::atomic<bool> end_{false};
  std::thread thread_;
};

}  // namespace mrroc::edp
