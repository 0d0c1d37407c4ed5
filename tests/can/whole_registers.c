/* Preloaded into user-mode Linux, which knows the floating-point registers up to AVX-512 and hands back only those: on a
   processor that has more (AMX) its host refuses. This adds the others as they are. */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <stdarg.h>
#include <string.h>
#include <sys/uio.h>

enum { get_registers = 0x4204, set_registers = 0x4205, all_of_xsave = 0x202 };

long ptrace(long request, ...) {
  va_list rest;
  va_start(rest, request);
  const long process = va_arg(rest, long);
  void* const address = va_arg(rest, void*);
  void* const data = va_arg(rest, void*);
  va_end(rest);
  static long (*next)(long, ...);
  if (next == 0) next = (long (*)(long, ...))dlsym(RTLD_NEXT, "ptrace");

  static char bytes[65536];
  const struct iovec* const known = data;
  struct iovec whole = {bytes, sizeof bytes};
  if (request == set_registers && (long)address == all_of_xsave && next(get_registers, process, address, &whole) == 0 &&
      known->iov_len < whole.iov_len) {
    memcpy(bytes, known->iov_base, known->iov_len);
    return next(request, process, address, &whole);
  }
  return next(request, process, address, data);
}
