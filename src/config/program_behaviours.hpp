#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "mrroc/message.hpp"

namespace mrroc::config {

/// What an ECP program says of itself when it is called with `--behaviours`.
struct ProgramBehaviours {
  std::vector<MessageSchema> on;   ///< what it can be started with
  std::vector<std::string> tells;  ///< labels of the messages that it tells the MP
};
using ProgramsByRobot = std::map<std::string, ProgramBehaviours>;

/// One line for each: `on Pick x:number:8 y:number:8`, `tells Arrived`.
std::string to_text(const ProgramBehaviours& behaviours);
/// The reverse. Throws std::runtime_error that quotes a line that is none.
ProgramBehaviours read_behaviours(const std::string& text);

/// Calls the program. Throws std::runtime_error when it does not say. Configuration time only: starts a process.
ProgramBehaviours behaviours_of(const std::filesystem::path& program);

}  // namespace mrroc::config
