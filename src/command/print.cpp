#include "command/print.hpp"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <string>

#include "command/printable.hpp"
#include "mrroc/errors.hpp"

namespace mrroc::command {

namespace {

[[noreturn]] void refuse(int reason) {
  throw SystemError(ErrorCode::resources,
                    std::string{"cannot write to the standard output: "} + std::strerror(reason != 0 ? reason : EIO));
}

}  // namespace

void print(std::string_view text) {
  const std::string shown = printable_lines(text);
  errno = 0;
  if (std::fwrite(shown.data(), 1, shown.size(), stdout) != shown.size() || std::fflush(stdout) != 0) refuse(errno);
}

void finish_output() {
  errno = 0;
  if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) refuse(errno);
}

}  // namespace mrroc::command
