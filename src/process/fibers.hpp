#pragma once

#include <atomic>
#include <exception>
#include <functional>
#include <memory>
#include <vector>

#include "clock/clock.hpp"

namespace mrroc::process {

/// The clock of a process whose task may run several fibers: lines of control that take turns in the task's thread of
/// control. One fiber runs at a time, each on a thread of its own; it yields when it waits on this clock, so that the
/// others can continue. Turns follow the order of the fibers, which makes lockstep deterministic; whenever something
/// has arrived they are repeated until no fiber has work. Outside of `run` it is the clock that it wraps.
class FiberScheduler final : public clock::Clock {
 public:
  explicit FiberScheduler(std::unique_ptr<clock::Clock> clock) : clock_(std::move(clock)) {}
  ~FiberScheduler() override;

  /// Runs the fibers until all have ended. When one throws, the others are instructed to stop (`cancelled`), and after
  /// their end the first error is thrown; `Stopped` only without another error. Throws NonFatalError(invalid_argument)
  /// when called by a fiber. Task's thread.
  void run(const std::vector<std::function<void()>>& fibers);
  /// Whether the running fiber should end because another has failed. The task's threads.
  bool cancelled() const noexcept { return cancelled_; }
  /// Call when the running fiber begins to wait for something new, or need not wait any more: another fiber may wait
  /// for its results, so all get another turn. The task's threads.
  void note_progress() noexcept { progress_ = true; }

  // ---- Clock
  double period() const noexcept override { return clock_->period(); }
  Tick tick() const noexcept override { return clock_->tick(); }
  bool simulated() const noexcept override { return clock_->simulated(); }
  std::int64_t epoch_ns() const noexcept override { return clock_->epoch_ns(); }
  double wall_seconds() const noexcept override { return clock_->wall_seconds(); }
  bool start() override { return clock_->start(); }
  clock::Wake wait(Tick wake_tick) override;
  bool stopping() const noexcept override { return clock_->stopping(); }
  void interrupt() noexcept override { clock_->interrupt(); }
  void notify() noexcept override { clock_->notify(); }
  Tick fault_tick(std::size_t index) const noexcept override { return clock_->fault_tick(index); }
  void set_off_fault(std::size_t index, Tick tick) noexcept override { clock_->set_off_fault(index, tick); }
  clock::EmergencyStop& emergency_stop() noexcept override { return clock_->emergency_stop(); }
  clock::GroupStops& group_stops() noexcept override { return clock_->group_stops(); }
  void end_task() noexcept override { clock_->end_task(); }
  int register_sender(std::string_view topic) override { return clock_->register_sender(topic); }
  int register_receiver(std::string_view topic) override { return clock_->register_receiver(topic); }
  std::uint64_t delta() const noexcept override { return clock_->delta(); }
  bool visible(std::uint64_t delta) const noexcept override { return clock_->visible(delta); }
  void sent(int sender) noexcept override {
    progress_ = true;
    clock_->sent(sender);
  }
  void arrived(int receiver) noexcept override { clock_->arrived(receiver); }

 private:
  struct Fiber;
  void take_turns(std::vector<std::unique_ptr<Fiber>>& fibers);
  void give_turn(Fiber& fiber, clock::Wake wake);

  std::unique_ptr<clock::Clock> clock_;
  Fiber* running_ = nullptr;
  std::exception_ptr error_;  // the first; errors take precedence over stops
  bool cancelled_ = false;
  std::atomic<bool> progress_ = false;  // since the round of turns began
};

}  // namespace mrroc::process
