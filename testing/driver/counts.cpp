#include "testing/driver/counts.hpp"

#include <dlfcn.h>
#include <pthread.h>
#include <sys/resource.h>

#include <cstddef>

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define MRROC_SANITIZED 1
#else
#define MRROC_SANITIZED 0
#endif

namespace {

constinit thread_local std::uint64_t allocated = 0;
constinit thread_local std::uint64_t locked = 0;

/// The function of this name that the program replaces.
template <class Function>
Function next(const char* name) noexcept {
  return reinterpret_cast<Function>(::dlsym(RTLD_NEXT, name));
}

}  // namespace

#if !MRROC_SANITIZED
extern "C" {
// glibc's own names of the functions that it lets a program replace
// NOLINTBEGIN(bugprone-reserved-identifier)
void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_realloc(void* memory, std::size_t size);
// NOLINTEND(bugprone-reserved-identifier)

void* malloc(std::size_t size) {
  ++allocated;
  return __libc_malloc(size);
}
void* calloc(std::size_t count, std::size_t size) {
  ++allocated;
  return __libc_calloc(count, size);
}
void* realloc(void* memory, std::size_t size) {
  ++allocated;
  return __libc_realloc(memory, size);
}

int pthread_mutex_lock(pthread_mutex_t* mutex) {
  ++locked;
  return next<int (*)(pthread_mutex_t*)>("pthread_mutex_lock")(mutex);
}
int pthread_rwlock_rdlock(pthread_rwlock_t* lock) {
  ++locked;
  return next<int (*)(pthread_rwlock_t*)>("pthread_rwlock_rdlock")(lock);
}
int pthread_rwlock_wrlock(pthread_rwlock_t* lock) {
  ++locked;
  return next<int (*)(pthread_rwlock_t*)>("pthread_rwlock_wrlock")(lock);
}
}
#endif

namespace mrroc::driver_test {

Counts counts() noexcept {
  rusage usage{};
  ::getrusage(RUSAGE_THREAD, &usage);
  return {allocated, locked, static_cast<std::uint64_t>(usage.ru_nvcsw)};
}

bool counts_allocations() noexcept { return !MRROC_SANITIZED; }

}  // namespace mrroc::driver_test
