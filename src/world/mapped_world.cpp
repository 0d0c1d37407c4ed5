#include "world/mapped_world.hpp"

#include <utility>

namespace mrroc::world {

namespace {

constexpr const char* kWhat = "memory of the simulated world";

}  // namespace

MappedWorld::MappedWorld(core::SharedMemory mapped) noexcept
    : mapped_(std::move(mapped)), memory_(static_cast<WorldMemory*>(mapped_.address())) {}

MappedWorld MappedWorld::create() {
  return MappedWorld(core::SharedMemory::create("mrroc-world", sizeof(WorldMemory), kWhat));
}

MappedWorld MappedWorld::attach(int fd) {
  return MappedWorld(core::SharedMemory::attach(fd, sizeof(WorldMemory), kWhat));
}

}  // namespace mrroc::world
