#pragma once

#include <map>
#include <string>
#include <vector>

#include "mrroc/message.hpp"

namespace mrroc::config {

/// The output of an ECP program for `--behaviours`.
struct ProgramBehaviours {
  std::vector<MessageSchema> on;   ///< messages that can start it
  std::vector<std::string> tells;  ///< labels of the messages that it sends to the MP
};
using ProgramsByRobot = std::map<std::string, ProgramBehaviours>;

/// One line for each: `on Pick x:number:8 y:number:8`, `tells Arrived`.
std::string to_text(const ProgramBehaviours& behaviours);
/// The reverse. Throws std::runtime_error that quotes an invalid line.
ProgramBehaviours read_behaviours(const std::string& text);

/// The same for several programs; each line begins with its robot.
std::string to_text(const ProgramsByRobot& programs);
/// The reverse. Throws the same.
ProgramsByRobot read_programs(const std::string& text);

}  // namespace mrroc::config
