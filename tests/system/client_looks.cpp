#include "system/client_looks.hpp"

#include <fstream>

#include "system/trace_line.hpp"

namespace mrroc::test {

std::string clients_deployment(const std::string& name, const std::string& shared, const std::string& free) {
  const std::string programs = "program = \"" MRROC_BINARY_DIR "/tests/several_clients_";
  const std::string belt = "type = \"conveyor\"\nhardware = \"loopback\"\n" + programs + "ecp\"\n";
  return "[deployment]\nname = \"" + name + "\"\n[mp]\n" + programs + "mp\"\n[robots.left]\n" + belt +
         "[robots.right]\n" + belt + "[sensors.shared]\n" + shared +
         "[sensors.free]\nmode = \"non-interactive\"\nrate = 25\n" + free;
}

std::map<std::string, std::vector<Look>> looks_of(const std::filesystem::path& trace) {
  std::map<std::string, std::vector<Look>> looks;
  std::ifstream file(trace);
  for (std::string line; std::getline(file, line);) {
    const auto shared = line.find(" sensor=shared "), free = line.find(" sensor=free "),
               name = line.find("process=") + 8;
    if (shared == std::string::npos) continue;
    const auto end = line.rfind(" end=");
    if (end != std::string::npos && line.find("_error", end) != std::string::npos) continue;  // it saw none there
    const std::string client = line.substr(name, line.find(' ', name) - name);
    std::vector<Look>& known = looks[client];
    Look look;
    look.step = numbers_after(line, " step=").at(0);
    look.shared = numbers_after(line.substr(shared), " tick=").at(0);
    look.value = numbers_after(line.substr(shared), " values=").at(0);
    look.free = numbers_after(line.substr(free), " tick=").at(0);
    const auto robot = numbers_after(line, " robot=" + client + " tick=");
    look.own = !robot.empty() ? robot[0] : look.step == 0 ? look.shared : known.back().own + 10;
    known.push_back(look);
  }
  return looks;
}

}  // namespace mrroc::test
