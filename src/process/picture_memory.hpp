#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

#include "core/shared_memory.hpp"
#include "mrroc/types.hpp"

namespace mrroc::process {

/// The newest picture of a camera in memory that its process shares with the programs beside the run: 8-bit RGB, rows
/// from top to bottom. The runner creates it, the camera's process attaches through the inherited descriptor, others
/// open it below /proc; it is anonymous (memfd), so it leaves no file. No reader delays the writer.
class PictureMemory {
 public:
  /// `width`, `height` in px. Throws SystemError(resources) when there is no memory.
  static PictureMemory create(int width, int height);
  /// Throws SystemError(resources) when `fd` is not the memory of such a picture. The descriptor stays the caller's.
  static PictureMemory attach(int fd, int width, int height);
  /// As `attach`, for a program of the same user: `file` is /proc/PID/fd/FD of the process that created it.
  static PictureMemory open(const std::filesystem::path& file, int width, int height);

  /// Descriptor of a memory that was created here; -1 otherwise. Closed with this object.
  int fd() const noexcept { return mapped_.fd(); }
  /// 3 * width * height.
  std::size_t bytes() const noexcept { return bytes_; }

  /// Stores a picture of `bytes()` bytes that was taken at this tick. The one writer's thread; allocates nothing.
  void store(Tick tick, std::span<const std::uint8_t> pixels) noexcept;
  /// Twice the number of stored pictures (odd while one is being stored): whether there is a new one. Any thread.
  std::uint64_t sequence() const noexcept;
  /// Copies the newest picture; false when none was stored, or the writer died in the middle. One thread.
  bool load(Tick& tick, std::vector<std::uint8_t>& pixels);

 private:
  PictureMemory(core::SharedMemory mapped, std::size_t bytes);

  core::SharedMemory mapped_;
  std::size_t bytes_;
  std::vector<std::uint64_t> words_;  // the tick, the pixels; a copy
};

}  // namespace mrroc::process
