#include "config/text/deployment_text.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <optional>

#include "config/table.hpp"
#include "config/text/file_text.hpp"

namespace mrroc::config {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMost = 16 << 20;  // bytes of a stream

[[noreturn]] void refuse(const fs::path& file, const std::string& problem, const std::string& expected) {
  throw ConfigurationError(file, 0, "", problem, expected);
}

/// The descriptor that `-`, `/dev/stdin`, `/dev/fd/N` or `/proc/self/fd/N` names.
std::optional<int> named_descriptor(const fs::path& file) {
  const std::string name = file.lexically_normal().string();
  if (name == "-" || name == "/dev/stdin") return STDIN_FILENO;
  for (const std::string_view folder : {"/dev/fd/", "/proc/self/fd/"}) {
    if (!name.starts_with(folder)) continue;
    int number = -1;
    const auto [end, error] = std::from_chars(name.data() + folder.size(), name.data() + name.size(), number);
    if (error == std::errc{} && end == name.data() + name.size()) return number;
  }
  return std::nullopt;
}

/// Reads up to the end; a signal can interrupt the wait for a writer.
std::string read_stream(int fd, const fs::path& file) {
  std::string text;
  std::array<char, 65536> block;
  for (;;) {
    const ssize_t size = ::read(fd, block.data(), block.size());
    if (size < 0 && errno == EINTR) continue;
    if (size < 0) refuse(file, std::string{"cannot be read: "} + std::strerror(errno), "a readable file");
    if (size == 0) return text;
    text.append(block.data(), static_cast<std::size_t>(size));
    if (text.size() > kMost) refuse(file, "does not end", "at most " + std::to_string(kMost) + " bytes");
  }
}

}  // namespace

DeploymentText read_deployment_text(const fs::path& file) {
  if (const auto fd = named_descriptor(file)) {
    const std::string name = *fd == STDIN_FILENO ? "stdin" : "fd-" + std::to_string(*fd);
    return {fs::current_path() / name, read_stream(*fd, file), false, *fd == STDIN_FILENO};
  }
  std::error_code none;
  if (fs::status(file, none).type() != fs::file_type::fifo) return {fs::absolute(file), read_file(file), true, false};
  const int fd = ::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NOCTTY);
  if (fd < 0) refuse(file, std::string{"cannot be read: "} + std::strerror(errno), "a readable file");
  DeploymentText deployment{fs::current_path() / file.filename(), "", false, false};
  try {
    deployment.text = read_stream(fd, file);
  } catch (...) {
    ::close(fd);
    throw;
  }
  ::close(fd);
  return deployment;
}

}  // namespace mrroc::config
