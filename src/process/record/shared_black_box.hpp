#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/shared_memory.hpp"
#include "process/record/encoded_step.hpp"
#include "recording/recorded_step.hpp"

namespace mrroc::process {

/// The last steps of one process, in memory that outlives it: for a task that is killed, crashes,
/// or is ended because of another process. The runner creates it, the process attaches through the inherited
/// descriptor; it is anonymous (memfd), so it leaves no file.
class SharedBlackBox {
 public:
  /// Throws SystemError(resources) when there is no memory.
  static SharedBlackBox create();
  /// Throws SystemError(resources) when `fd` is not such a memory. The descriptor stays the caller's.
  static SharedBlackBox attach(int fd);

  /// Descriptor of a memory that was created here; -1 otherwise. Closed with this object.
  int fd() const noexcept { return mapped_.fd(); }

  /// Replaces the oldest step by a copy of this one, which was made at this tick. Task's thread; neither allocates nor
  /// blocks.
  void record(Tick tick, const EncodedStep& step) noexcept;

  /// The number of the file to which the task has written its black box (black_box_path); 0: not written.
  void note_file(std::uint64_t number) noexcept;
  std::uint64_t file() const noexcept;
  /// Bytes of memory of each.
  static std::size_t memory_size() noexcept;

  /// The last complete steps, at most BlackBox::kSteps, the oldest first. While the process records, steps that it
  /// replaces meanwhile are left out: those that remain are whole, without a gap. Any thread; never delays the process.
  std::vector<recording::RecordedStep> steps() const;

 private:
  struct Memory;
  explicit SharedBlackBox(core::SharedMemory mapped) noexcept;

  core::SharedMemory mapped_;
  Memory* memory_;
};

}  // namespace mrroc::process
