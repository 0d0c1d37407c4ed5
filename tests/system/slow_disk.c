/* Preloaded: a disk that takes MRROC_TEST_DISK_DELAY s for the first LARGE or more bytes of a recording. */
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/syscall.h>
#include <time.h>
#include <unistd.h>

enum { LARGE = 10000 };

static int is_recording(int file) {
  char link[64], path[4096];
  snprintf(link, sizeof link, "/proc/self/fd/%d", file);
  const ssize_t size = readlink(link, path, sizeof path - 1);
  return size > 5 && memcmp(path + size - 5, ".mcap", 5) == 0;
}

ssize_t write(int file, const void* data, size_t size) {
  static atomic_flag delayed = ATOMIC_FLAG_INIT;
  const char* const delay = getenv("MRROC_TEST_DISK_DELAY");
  if (delay != NULL && size >= LARGE && is_recording(file) && !atomic_flag_test_and_set(&delayed))
    nanosleep(&(struct timespec){atol(delay), 0}, NULL);
  return syscall(SYS_write, file, data, size);
}
