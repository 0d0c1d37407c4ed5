#pragma once

#include <cstddef>
#include <string>

namespace mrroc::core {

/// Memory that processes share: the one that creates it hands the descriptor down to its children. It has no name in
/// the file system, so nothing of it is left when the processes have died.
class SharedMemory {
 public:
  /// New memory of `size` bytes, all zero, in the kernel's lists as `name`; `what` is its name in messages. Throws
  /// SystemError(resources).
  static SharedMemory create(const char* name, std::size_t size, const std::string& what);
  /// The memory behind a descriptor, which stays open. Throws SystemError(resources), also when it has another size.
  static SharedMemory attach(int fd, std::size_t size, const std::string& what);
  ~SharedMemory();
  SharedMemory(SharedMemory&& other) noexcept;
  SharedMemory& operator=(SharedMemory&&) = delete;

  /// Aligned to a page; every page is there: the first access to one does not wait for the kernel.
  void* address() const noexcept { return address_; }
  /// For children; -1 where it was attached.
  int fd() const noexcept { return fd_; }

 private:
  SharedMemory(int mapped, int owned, std::size_t size, const std::string& what);

  void* address_;
  std::size_t size_;
  int fd_;
};

}  // namespace mrroc::core
