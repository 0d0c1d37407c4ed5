#pragma once

#include <atomic>
#include <cstdint>
#include <memory>

#include "core/lockfree/spsc_queue.hpp"
#include "edp/safety/fault.hpp"
#include "edp/servo/servo_state.hpp"
#include "mrroc/types.hpp"

namespace mrroc::edp {

/// What the servo read, wanted and gave in one tick.
struct ServoSample {
  Tick tick = 0;
  double ahead = 0;                ///< of the tick, of a robot that keeps the time (Servo)
  double measured = 0;             ///< time of `motors` and `current`, ticks
  JointVector motors;              ///< shafts, rad
  JointVector current;             ///< measured, A
  JointVector set_point;           ///< of the shafts, rad
  JointVector given;               ///< current for the coming period, A
  Wrench wrench = Wrench::Zero();  ///< in the axes and about the origin of the force sensor's frame; zero without one
  ControllerIo inputs, outputs;
  ServoState state = ServoState::off;
  Fault fault;
};

/// A recorder's connection to one servo: every tick puts a sample into a ring of kCapacity, in which the recorder's
/// thread finds them in their order. A recorder that is too slow, or hangs, loses the newest samples, which are
/// counted; the servo does not wait for it. Wait-free on both sides; only the constructor allocates.
class ServoTap {
 public:
  static constexpr std::size_t kCapacity = 4096;  ///< 8 s at 500 Hz

  ServoTap() : ring_(std::make_unique<Ring>()) {}

  /// Servo thread.
  void put(const ServoSample& sample) noexcept {
    if (!ring_->push(sample)) dropped_.store(dropped() + 1, std::memory_order_relaxed);
  }

  /// The oldest sample, or null; it stays valid until `pop`. The recorder's thread.
  const ServoSample* front() const noexcept { return ring_->front(); }
  /// Removes the oldest sample; there must be one. The recorder's thread.
  void pop() noexcept { ring_->pop(); }
  /// Samples that did not fit. Any thread.
  std::uint64_t dropped() const noexcept { return dropped_.load(std::memory_order_relaxed); }

 private:
  using Ring = core::SpscQueue<ServoSample, kCapacity>;
  std::unique_ptr<Ring> ring_;
  std::atomic<std::uint64_t> dropped_{0};
};

}  // namespace mrroc::edp
