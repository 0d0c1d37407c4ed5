#include "command/replaceable.hpp"

#include <fstream>
#include <stdexcept>

namespace mrroc::command {

bool is_replaceable(const std::filesystem::path& file, std::string_view beginning) {
  std::error_code none;
  if (!std::filesystem::is_regular_file(file, none) || std::filesystem::file_size(file, none) == 0) return true;
  std::ifstream stream(file, std::ios::binary);
  std::string found(beginning.size(), '\0');
  return stream.read(found.data(), static_cast<std::streamsize>(found.size())) && found == beginning;
}

void check_replaceable(const std::filesystem::path& file, std::string_view beginning, const std::string& what,
                       const std::string& kind) {
  if (is_replaceable(file, beginning)) return;
  throw std::runtime_error(std::string(what).append(" ").append(file.string()) +
                           ": holds something else, expected a new file, or " + kind + " to replace");
}

}  // namespace mrroc::command
