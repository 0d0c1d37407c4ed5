#pragma once

#include <fcntl.h>

#include <cstdlib>

namespace mrroc::process {

/// Opens /dev/null for each of the descriptors 0, 1 and 2 that is closed, as in a program started by a service or a
/// cron job. Afterwards no file that the program opens has one of these numbers. The first statement of every `main`
/// (of task programs: by MRROC_ECP, MRROC_MP and the like), while there is one thread. Aborts where there is no
/// /dev/null, as the C library does for set-user-ID programs.
inline void open_standard_files() noexcept {
  for (int fd = 0; fd <= 2; ++fd) {
    // the kernel uses the lowest free number: those below are already open
    if (::fcntl(fd, F_GETFD) < 0 && ::open("/dev/null", O_RDWR) != fd) std::abort();
  }
}

}  // namespace mrroc::process
