#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>

#include "core/shared_ring.hpp"
#include "mrroc/types.hpp"
#include "process/record/encoded_step.hpp"
#include "recording/recorded_step.hpp"

namespace mrroc::process {

/// Carries the steps of one process to the runner, which records them (core::SharedRing). Many steps fit in; when the
/// runner does not take them in time, under the real clock a step is dropped and counted, under a simulated clock time
/// waits for the runner.
class StepRing {
 public:
  static constexpr std::size_t kSteps = 64;

  /// Throws SystemError(resources) when there is no memory.
  static StepRing create();
  /// Throws SystemError(resources) when `fd` is not such a memory. The descriptor stays the caller's.
  static StepRing attach(int fd);

  /// Bytes of memory of each.
  static constexpr std::size_t memory_size() noexcept { return Ring::memory_size(); }
  /// Descriptor of a memory that was created here; -1 otherwise. Closed with this object.
  int fd() const noexcept { return ring_.fd(); }

  /// Adds a step that was made at this tick. `waits`: as of core::SharedRing::claim. Task's thread; does not allocate.
  void add(Tick tick, const EncodedStep& step, bool waits) noexcept;
  /// The process makes no further step. Task's thread.
  void end() noexcept { ring_.end(); }

  /// The oldest step, or nothing. The runner's one thread.
  std::optional<recording::RecordedStep> take();
  /// Whether the process has ended in order: it was not killed. Any thread.
  bool ended() const noexcept { return ring_.ended(); }
  /// Steps that were added, and those that were dropped. Any thread.
  std::uint64_t added() const noexcept { return ring_.added(); }
  std::uint64_t dropped() const noexcept { return ring_.dropped(); }

 private:
  struct Entry {
    Tick tick;
    std::size_t size;
    std::array<std::byte, EncodedStep::kCapacity> bytes;
  };
  using Ring = core::SharedRing<Entry, kSteps>;

  explicit StepRing(Ring ring) noexcept : ring_(std::move(ring)) {}

  Ring ring_;
};

}  // namespace mrroc::process
