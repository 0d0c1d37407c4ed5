#include "command/write_file.hpp"

#include <cerrno>
#include <cstdio>
#include <cstring>

#include "mrroc/errors.hpp"

namespace mrroc::command {

void write_file(const std::filesystem::path& file, std::span<const std::byte> bytes) {
  std::FILE* const stream = std::fopen(file.c_str(), "wbe");
  int problem = stream == nullptr ? errno : 0;
  if (problem == 0 && std::fwrite(bytes.data(), 1, bytes.size(), stream) != bytes.size()) problem = errno;
  if (stream != nullptr && std::fclose(stream) != 0 && problem == 0) problem = errno;
  if (problem != 0)
    throw SystemError(ErrorCode::resources, "cannot write " + file.string() + ": " + std::strerror(problem));
}

}  // namespace mrroc::command
