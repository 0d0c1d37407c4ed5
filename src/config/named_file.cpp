#include "config/named_file.hpp"

#include <unistd.h>

#include "config/file_text.hpp"
#include "config/message_text.hpp"
#include "config/resources.hpp"

namespace mrroc::config {

namespace fs = std::filesystem;

namespace {

fs::path beside(const fs::path& file, const fs::path& name) {
  return (fs::absolute(file).parent_path() / name).lexically_normal();
}

}  // namespace

fs::path require_file(const Table& table, std::string_view key) {
  const std::string name = table.text(key);
  const fs::path path = beside(table.file(), name);
  const auto problem = reading_problem(path);
  if (!problem.empty()) table.fail(key, in_quotes(name) + " " + problem, "a readable file " + path.string());
  return path;
}

std::string require_program(const Table& table, std::string_view key, const std::string& program) {
  const bool is_path = program.find('/') != std::string::npos;
  const fs::path path = is_path ? beside(table.file(), program) : program_directory() / program;
  const std::string expected = "the executable " + path.string();
  std::error_code error;
  if (!fs::is_regular_file(path, error)) table.fail(key, "no program " + in_quotes(program), expected);
  if (access(path.c_str(), X_OK) != 0) table.fail(key, in_quotes(program) + " is not executable", expected);
  return path.string();
}

}  // namespace mrroc::config
