#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "process/record/text_line.hpp"

namespace mrroc::process {

/// The last steps of one process as lines of a trace, in memory that outlives it: what is left of a task that is
/// killed, crashes, or is ended because another has. The runner creates it, the process attaches through the inherited
/// descriptor; it is anonymous (memfd), so nothing is left behind.
class SharedBlackBox {
 public:
  /// Throws SystemError(resources) when there is no memory.
  static SharedBlackBox create();
  /// Throws SystemError(resources) when `fd` is no such memory. The descriptor stays the caller's.
  static SharedBlackBox attach(int fd);
  ~SharedBlackBox();
  SharedBlackBox(SharedBlackBox&& other) noexcept;
  SharedBlackBox& operator=(SharedBlackBox&&) = delete;

  /// Descriptor of a memory that was created here; -1 otherwise. Closed with this object.
  int fd() const noexcept { return fd_; }

  /// Keeps a copy of the line in place of the oldest one. The task's thread; neither allocates nor blocks.
  void record(const TextLine& line) noexcept;

  /// The number of the file that the task has written its black box to (black_box_path); 0: none.
  void note_file(std::uint64_t number) noexcept;
  std::uint64_t file() const noexcept;
  /// Bytes of memory of each.
  static std::size_t memory_size() noexcept;

  /// The last lines that are whole, at most BlackBox::kSteps, the oldest first. Anywhere, once the process that wrote
  /// them has ended.
  std::vector<TextLine> lines() const;

 private:
  struct Memory;
  SharedBlackBox(Memory* memory, int fd) noexcept : memory_(memory), fd_(fd) {}
  static Memory* map(int fd) noexcept;

  Memory* memory_;
  int fd_;
};

}  // namespace mrroc::process
