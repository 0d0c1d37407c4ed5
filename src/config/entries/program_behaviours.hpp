#pragma once

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

/// The same of several programs, each line begun by its robot.
std::string to_text(const ProgramsByRobot& programs);
/// The reverse. Throws likewise.
ProgramsByRobot read_programs(const std::string& text);

}  // namespace mrroc::config
