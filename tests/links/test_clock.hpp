#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>

#include "clock/clock.hpp"
#include "clock/wall/monotonic.hpp"

namespace mrroc::links {

/// A clock for one process: real time, or simulated time in which every wait is a new delta and ticks do not advance. A
/// test that would hang is interrupted after a minute.
class TestClock final : public clock::Clock {
 public:
  explicit TestClock(bool simulated = false) : simulated_(simulated) {}

  double period() const noexcept override { return 0.002; }
  Tick tick() const noexcept override {
    return simulated_ ? 0 : static_cast<Tick>((clock::monotonic_ns() - start_) / 2'000'000);
  }
  bool simulated() const noexcept override { return simulated_; }
  double wall_seconds() const noexcept override { return static_cast<double>(clock::monotonic_ns()) * 1e-9; }
  std::int64_t epoch_ns() const noexcept override { return epoch.load(); }
  bool start() override { return true; }

  clock::Wake wait(Tick wake_tick) override {
    std::unique_lock lock(mutex_);
    auto limit = std::chrono::steady_clock::now() + std::chrono::minutes(1);
    bool due = false;
    const Tick now = tick();
    constexpr Tick kMinute = 30000;
    if (!simulated_ && wake_tick < now + kMinute) {
      const Tick ahead = wake_tick > now ? wake_tick - now : 0;
      limit = std::chrono::steady_clock::now() + std::chrono::milliseconds(2 * ahead);
      due = true;
    }
    const bool woken = wake_.wait_until(lock, limit, [this] { return interrupted_ || openings_ != seen_; });
    delta_.fetch_add(1);
    if (interrupted_ || (!woken && !due)) return clock::Wake::interrupted;
    seen_ = openings_;
    return woken ? clock::Wake::mail : clock::Wake::tick;
  }

  void interrupt() noexcept override {
    const std::lock_guard lock(mutex_);
    interrupted_ = true;
    wake_.notify_all();
  }
  void notify() noexcept override {
    notified.fetch_add(1);
    open();
  }
  clock::EmergencyStop& emergency_stop() noexcept override { return emergency_stop_; }
  clock::GroupStops& group_stops() noexcept override { return group_stops_; }

  int register_sender(std::string_view) override { return senders.fetch_add(1); }
  int register_receiver(std::string_view) override { return receivers.fetch_add(1); }
  std::uint64_t delta() const noexcept override { return delta_.load(); }
  bool visible(std::uint64_t delta) const noexcept override { return !simulated_ || delta < delta_.load(); }
  void sent(int) noexcept override { in_flight.fetch_add(1); }
  void arrived(int) noexcept override {
    in_flight.fetch_sub(1);
    open();
  }

  void next_delta() { delta_.fetch_add(1); }

  std::atomic<std::int64_t> epoch{0};  ///< CLOCK_MONOTONIC time of tick 0, for stamps only
  std::atomic<int> senders{0};
  std::atomic<int> receivers{0};
  std::atomic<int> in_flight{0};
  std::atomic<int> notified{0};

 private:
  void open() noexcept {
    const std::lock_guard lock(mutex_);
    ++openings_;
    wake_.notify_all();
  }

  const bool simulated_;
  clock::EmergencyStop emergency_stop_;
  clock::GroupStops group_stops_;
  const std::int64_t start_ = clock::monotonic_ns();
  std::atomic<std::uint64_t> delta_{1};
  std::mutex mutex_;
  std::condition_variable wake_;
  bool interrupted_ = false;
  std::uint64_t openings_ = 0;
  std::uint64_t seen_ = 0;
};

}  // namespace mrroc::links
