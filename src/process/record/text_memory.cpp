#include "process/record/text_memory.hpp"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "mrroc/errors.hpp"

namespace mrroc::process {

namespace {

bool write_all(int fd, const std::string& text) {
  for (std::size_t written = 0; written < text.size();) {
    const ssize_t size = ::write(fd, text.data() + written, text.size() - written);
    if (size < 0 && errno == EINTR) continue;
    if (size <= 0) return false;
    written += static_cast<std::size_t>(size);
  }
  return fcntl(fd, F_ADD_SEALS, F_SEAL_SHRINK | F_SEAL_GROW | F_SEAL_WRITE | F_SEAL_SEAL) == 0;
}

}  // namespace

TextMemory::TextMemory(const std::string& text)
    : fd_(memfd_create("mrroc-deployment", MFD_CLOEXEC | MFD_ALLOW_SEALING)) {
  if (fd_ >= 0 && write_all(fd_, text)) return;
  const std::string reason = std::strerror(errno);
  if (fd_ >= 0) ::close(fd_);
  throw SystemError(ErrorCode::resources, "memory of the deployment's text: " + reason);
}

TextMemory::~TextMemory() { ::close(fd_); }

std::string read_text(int fd) {
  struct stat status {};
  std::string text;
  if (fstat(fd, &status) == 0) text.resize(static_cast<std::size_t>(status.st_size));
  for (std::size_t done = 0; done < text.size();) {
    const ssize_t size = pread(fd, text.data() + done, text.size() - done, static_cast<off_t>(done));
    if (size < 0 && errno == EINTR) continue;
    if (size <= 0)
      throw SystemError(ErrorCode::resources, "descriptor " + std::to_string(fd) + ": " + std::strerror(errno));
    done += static_cast<std::size_t>(size);
  }
  return text;
}

}  // namespace mrroc::process
