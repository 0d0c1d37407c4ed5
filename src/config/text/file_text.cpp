#include "config/text/file_text.hpp"

#include <array>
#include <cerrno>
#include <cstdio>
#include <memory>
#include <system_error>

#include "config/table.hpp"

namespace mrroc::config {

namespace fs = std::filesystem;

namespace {

using File = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

File open(const fs::path& file) { return {std::fopen(file.c_str(), "rbe"), &std::fclose}; }

std::string system_reason() { return "cannot be read: " + std::generic_category().message(errno); }

[[noreturn]] void refuse(const fs::path& file, const std::string& problem) {
  throw ConfigurationError(file, 0, "", problem, "a readable file");
}

}  // namespace

std::string reading_problem(const fs::path& file) {
  std::error_code error;
  const auto status = fs::status(file, error);
  if (status.type() == fs::file_type::not_found) return "does not exist";
  if (error) return "cannot be read: " + error.message();
  if (fs::is_directory(status)) return "is a directory";
  if (!fs::is_regular_file(status)) return "is not a regular file";  // a pipe could block forever
  return open(file) ? "" : system_reason();
}

std::string read_file(const fs::path& file) {
  if (const auto problem = reading_problem(file); !problem.empty()) refuse(file, problem);
  const File stream = open(file);
  if (!stream) refuse(file, system_reason());
  std::string bytes;
  std::array<char, 65536> block;
  while (const std::size_t count = std::fread(block.data(), 1, block.size(), stream.get())) {
    bytes.append(block.data(), count);
  }
  if (std::ferror(stream.get()) != 0) refuse(file, system_reason());
  return bytes;
}

}  // namespace mrroc::config
