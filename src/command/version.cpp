#include "command/version.hpp"

namespace mrroc::command {

std::string_view version() noexcept { return MRROC_VERSION; }

std::string version_text(std::string_view program) {
  return std::string{program} + (program == "mrroc" ? " " : " (MRROC++) ") + std::string{version()};
}

}  // namespace mrroc::command
