#pragma once

#include "core/shared_memory.hpp"
#include "world/world_memory.hpp"

namespace mrroc::world {

/// The simulated hardware's memory mapped into this process. The runner creates it, its children attach through the
/// inherited descriptor; it is anonymous (memfd), so it leaves no files.
class MappedWorld {
 public:
  /// Throws SystemError when there is no memory.
  static MappedWorld create();
  /// Throws SystemError when `fd` is not the memory of a world. The descriptor stays the caller's.
  static MappedWorld attach(int fd);

  WorldMemory& operator*() const noexcept { return *memory_; }
  WorldMemory* operator->() const noexcept { return memory_; }
  /// Descriptor of a memory that was created here; -1 otherwise. Closed with this object.
  int fd() const noexcept { return mapped_.fd(); }

 private:
  explicit MappedWorld(core::SharedMemory mapped) noexcept;

  core::SharedMemory mapped_;
  WorldMemory* memory_;
};

}  // namespace mrroc::world
