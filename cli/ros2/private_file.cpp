#include "cli/ros2/private_file.hpp"

#include <fcntl.h>
#include <stdlib.h>
#include <unistd.h>

#include <cerrno>
#include <stdexcept>
#include <string>
#include <system_error>
#include <utility>

namespace mrroc::cli {

namespace {

constexpr std::string_view kEnd = ".toml";

/// 0, or errno.
int write_all(int file, std::string_view text) {
  while (!text.empty()) {
    const ssize_t count = ::write(file, text.data(), text.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return errno;
    text.remove_prefix(static_cast<std::size_t>(count));
  }
  return 0;
}

[[noreturn]] void throw_unwritten(const std::string& path, int error) {
  throw std::runtime_error(path + ": not written: " + std::system_category().message(error));
}

}  // namespace

PrivateFile::PrivateFile(const std::filesystem::path& folder, std::string_view text) {
  std::string name = (folder / "trajectory-XXXXXX").string().append(kEnd);
  const int file = ::mkostemps(name.data(), static_cast<int>(kEnd.size()), O_CLOEXEC);
  if (file < 0) throw_unwritten(name, errno);
  const int error = write_all(file, text);
  ::close(file);
  if (error != 0) {
    ::unlink(name.c_str());
    throw_unwritten(name, error);
  }
  path_ = name;
}

PrivateFile::PrivateFile(PrivateFile&& other) noexcept : path_(std::exchange(other.path_, {})) {}

PrivateFile::~PrivateFile() {
  if (!path_.empty()) ::unlink(path_.c_str());
}

}  // namespace mrroc::cli
