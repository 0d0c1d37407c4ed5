#include "config/table.hpp"
#include "core/shown_text.hpp"

namespace mrroc::config {

namespace {

std::string compose(const std::filesystem::path& file, int line, const std::string& key, const std::string& problem,
                    const std::string& expected) {
  std::string message = file.string();
  if (line > 0) message.append(":").append(std::to_string(line));
  if (!message.empty()) message += ": ";
  if (!key.empty()) message += key + ": ";
  message += problem;
  if (!expected.empty()) message += ", expected " + expected;
  return core::shown(message);
}

}  // namespace

ConfigurationError::ConfigurationError(const std::filesystem::path& file, int line, const std::string& key,
                                       const std::string& problem, const std::string& expected)
    : std::runtime_error(compose(file, line, key, problem, expected)),
      parts_(std::make_shared<const Parts>(Parts{key, problem, expected})) {}

}  // namespace mrroc::config
