#include "world/mapped_world.hpp"

#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <string>

#include "mrroc/errors.hpp"

namespace mrroc::world {

namespace {

WorldMemory* map(int fd) {
  void* memory = mmap(nullptr, sizeof(WorldMemory), PROT_READ | PROT_WRITE, MAP_SHARED, fd, 0);
  return memory == MAP_FAILED ? nullptr : static_cast<WorldMemory*>(memory);
}

[[noreturn]] void refuse(const std::string& what) {
  throw SystemError(ErrorCode::resources, "memory of the simulated world: " + what);
}

}  // namespace

MappedWorld MappedWorld::create() {
  const int fd = memfd_create("mrroc-world", MFD_CLOEXEC);
  if (fd < 0) refuse(std::strerror(errno));
  WorldMemory* memory = ftruncate(fd, sizeof(WorldMemory)) == 0 ? map(fd) : nullptr;
  if (memory == nullptr) {
    const std::string reason = std::strerror(errno);
    close(fd);
    refuse(reason);
  }
  return {memory, fd};
}

MappedWorld MappedWorld::attach(int fd) {
  struct stat status {};
  if (fstat(fd, &status) != 0 || status.st_size != static_cast<off_t>(sizeof(WorldMemory))) {
    refuse("descriptor " + std::to_string(fd) + " is not such a memory");
  }
  WorldMemory* memory = map(fd);
  if (memory == nullptr) refuse(std::strerror(errno));
  return {memory, -1};
}

MappedWorld::~MappedWorld() {
  if (memory_ != nullptr) munmap(memory_, sizeof(WorldMemory));
  if (fd_ >= 0) close(fd_);
}

MappedWorld::MappedWorld(MappedWorld&& other) noexcept : memory_(other.memory_), fd_(other.fd_) {
  other.memory_ = nullptr;
  other.fd_ = -1;
}

}  // namespace mrroc::world
