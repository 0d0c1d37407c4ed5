#include "core/shared_memory.hpp"

#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

#include "mrroc/errors.hpp"

namespace mrroc::core {

namespace {

[[noreturn]] void refuse(const std::string& what, const std::string& why) {
  throw SystemError(ErrorCode::resources, what + ": " + why);
}

}  // namespace

SharedMemory::SharedMemory(int mapped, int owned, std::size_t size, const std::string& what)
    : address_(mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_POPULATE, mapped, 0)),
      size_(size),
      fd_(owned) {
  if (address_ != MAP_FAILED) return;
  const std::string reason = std::strerror(errno);
  if (owned >= 0) close(owned);
  refuse(what, reason);
}

SharedMemory SharedMemory::create(const char* name, std::size_t size, const std::string& what) {
  const int fd = memfd_create(name, MFD_CLOEXEC);
  if (fd < 0) refuse(what, std::strerror(errno));
  if (ftruncate(fd, static_cast<off_t>(size)) != 0) {
    const std::string reason = std::strerror(errno);
    close(fd);
    refuse(what, reason);
  }
  return {fd, fd, size, what};
}

SharedMemory SharedMemory::attach(int fd, std::size_t size, const std::string& what) {
  struct stat status {};
  if (fstat(fd, &status) != 0 || status.st_size != static_cast<off_t>(size))
    refuse(what, "descriptor " + std::to_string(fd) + " is not such a memory");
  return {fd, -1, size, what};
}

SharedMemory::~SharedMemory() {
  if (address_ != nullptr) munmap(address_, size_);
  if (fd_ >= 0) close(fd_);
}

SharedMemory::SharedMemory(SharedMemory&& other) noexcept
    : address_(std::exchange(other.address_, nullptr)), size_(other.size_), fd_(std::exchange(other.fd_, -1)) {}

}  // namespace mrroc::core
