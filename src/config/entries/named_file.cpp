#include "config/entries/named_file.hpp"

#include <unistd.h>

#include "config/resources.hpp"
#include "config/text/file_text.hpp"
#include "config/text/message_text.hpp"

namespace mrroc::config {

namespace fs = std::filesystem;

namespace {

/// The possible paths of `program`, in search order.
std::vector<fs::path> places(const Table& table, const std::string& program) {
  if (program.find('/') != std::string::npos) return {beside(table.file(), program)};
  std::vector<fs::path> paths = program_directories();
  for (fs::path& path : paths) path /= program;
  return paths;
}

}  // namespace

fs::path beside(const fs::path& file, const fs::path& name) {
  return (fs::absolute(file).parent_path() / name).lexically_normal();
}

fs::path require_file(const Table& table, std::string_view key) {
  const std::string name = table.text(key);
  fs::path path = beside(table.file(), name);
  const auto problem = reading_problem(path);
  if (!problem.empty()) table.fail(key, in_quotes(name) + " " + problem, "a readable file " + path.string());
  return path;
}

std::string require_program(const Table& table, std::string_view key, const std::string& program) {
  std::string expected;
  for (const fs::path& path : places(table, program)) {
    expected += (expected.empty() ? "the executable " : " or ") + path.string();
    std::error_code error;
    if (!fs::is_regular_file(path, error)) continue;
    if (access(path.c_str(), X_OK) != 0) table.fail(key, in_quotes(program) + " is not executable", expected);
    return path.string();
  }
  table.fail(key, "no program " + in_quotes(program), expected);
}

std::filesystem::path require_library(const Table& table, std::string_view key, const std::string& kind,
                                      const std::string& name) {
  std::vector<std::string> places;
  for (const std::filesystem::path& folder : plugin_directories(kind)) {
    std::filesystem::path library = folder / (name + ".so");
    std::error_code none;
    if (std::filesystem::is_regular_file(library, none)) return library;
    places.push_back(library.string());
  }
  table.fail(key, "the library of " + in_quotes(name) + " is not there", alternatives(places));
}

}  // namespace mrroc::config
