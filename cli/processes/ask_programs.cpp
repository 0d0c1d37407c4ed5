#include "cli/processes/ask_programs.hpp"

#include <stdexcept>

#include "cli/processes/child.hpp"
#include "config/table.hpp"
#include "config/text/message_text.hpp"

namespace mrroc::cli {

namespace {

config::ProgramBehaviours ask(const std::string& program) {
  Child child("behaviours", program, {"--behaviours"});
  const std::string text = child.wait_for_output();
  if (child.exit_code() != 0) throw std::runtime_error("does not report its behaviours: " + child.how_it_ended());
  return config::read_behaviours(text);
}

}  // namespace

config::ProgramsByRobot ask_programs(const config::Deployment& deployment) {
  config::ProgramsByRobot programs;
  for (const config::RobotEntry& robot : deployment.robots) {
    try {
      programs[robot.name] = ask(robot.program);
    } catch (const std::runtime_error& error) {
      throw config::ConfigurationError(deployment.file, 0, "robots." + robot.name + ".program",
                                       config::in_quotes(robot.program) + " " + error.what(), "an ECP program");
    }
  }
  return programs;
}

}  // namespace mrroc::cli
