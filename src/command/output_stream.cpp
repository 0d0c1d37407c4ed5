#include "command/output_stream.hpp"

#include <fcntl.h>
#include <unistd.h>

namespace mrroc::command {

std::FILE* output_stream(int fd) noexcept {
  const int copy = fcntl(fd, F_DUPFD_CLOEXEC, 3);
  std::FILE* const stream = copy < 0 ? nullptr : fdopen(copy, "w");
  if (stream == nullptr && copy >= 0) ::close(copy);
  return stream;
}

}  // namespace mrroc::command
