#include "system/client_looks.hpp"

#include <stdexcept>

#include "system/trace_steps_of.hpp"

namespace mrroc::test {

std::string clients_deployment(const std::string& name, const std::string& shared, const std::string& free) {
  const std::string programs = "program = \"" MRROC_BINARY_DIR "/tests/several_clients_";
  const std::string belt = "type = \"conveyor\"\nhardware = \"loopback\"\n" + programs + "ecp\"\n";
  return "[deployment]\nname = \"" + name + "\"\n[mp]\n" + programs + "mp\"\n[robots.left]\n" + belt +
         "[robots.right]\n" + belt + "[sensors.shared]\n" + shared +
         "[sensors.free]\nmode = \"non-interactive\"\nrate = 25\n" + free;
}

double number_after(const std::string& output, const std::string& word) {
  const std::size_t at = output.find(word);
  if (at == std::string::npos) throw std::runtime_error("'" + word + "' is missing in\n" + output);
  return std::stod(output.substr(at + word.size()));
}

std::map<std::string, std::vector<Look>> looks_of(const std::filesystem::path& trace) {
  std::map<std::string, std::vector<Look>> looks;
  for (const cli::trace::Line& line : steps_of(trace)) {
    const cli::trace::SensorEntry* const shared = sensor_in(line, "shared");
    if (shared == nullptr) continue;
    if (line.ending >= StepEnding::non_fatal_error) continue;  // it saw none there
    const cli::trace::SensorEntry* const free = sensor_in(line, "free");
    if (free == nullptr) throw std::runtime_error("the step has no reading of the sensor 'free'");
    std::vector<Look>& known = looks[line.process];
    Look look;
    look.step = static_cast<double>(line.step);
    look.shared = static_cast<double>(shared->tick);
    look.value = shared->values.at(0);
    look.free = static_cast<double>(free->tick);
    const cli::trace::RobotEntry* const robot = robot_in(line, line.process);
    look.own = robot != nullptr ? static_cast<double>(robot->tick)
               : look.step == 0 ? look.shared
                                : known.back().own + 10;
    known.push_back(look);
  }
  return looks;
}

}  // namespace mrroc::test
