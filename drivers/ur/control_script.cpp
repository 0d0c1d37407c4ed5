#include "drivers/ur/control_script.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>

#include "clock/wall/monotonic.hpp"
#include "config/resources.hpp"
#include "drivers/ur/tcp_socket.hpp"

namespace mrroc::ur {
namespace {

constexpr int kRealRegisters = 12, kIntegerRegisters = 3;

std::string number(double value) {
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << value;
  return text.str();
}

/// Lines of the script that set the payload and the tool's voltage. Without a load the payload of the teach pendant
/// stays: 0 would be wrong for every tool.
std::string settings(const UrOptions& options) {
  std::string lines = "# payload and tool";
  if (options.payload_mass > 0)
    lines += "\n  set_payload(" + number(options.payload_mass) + ", [" + number(options.payload_centre[0]) + ", " +
             number(options.payload_centre[1]) + ", " + number(options.payload_centre[2]) + "])";
  if (options.tool_voltage >= 0) lines += "\n  set_tool_voltage(" + std::to_string(options.tool_voltage) + ")";
  return lines;
}

}  // namespace

std::string read_control_script(const UrOptions& options) {
  const std::filesystem::path path =
      options.script.empty() ? config::type_file("drivers", "ur", "control.script") : options.script;
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  if (!file) throw std::runtime_error(path.string() + ": the control script cannot be read");
  if (!text.str().starts_with(kScriptHeader))
    throw std::runtime_error(path.string() + ": not a control script of this driver, expected the first line \"" +
                             std::string(kScriptHeader) + "\"");
  return text.str();
}

std::string control_program(const std::string& script, const UrOptions& options, double frequency,
                            std::int32_t program) {
  std::map<std::string, std::string, std::less<>> words{
      {"WATCHDOG", std::to_string(std::lround(std::ceil(options.watchdog * frequency)))},
      {"LOOKAHEAD", number(options.servo_lookahead)},
      {"GAIN", number(options.servo_gain)},
      {"SPEED_ACCELERATION", number(options.speed_acceleration)},
      {"STOP_ACCELERATION", number(options.stop_acceleration)},
      {"SETTINGS", settings(options)},
      {"PROGRAM", std::to_string(program)}};
  for (int i = 0; i < kRealRegisters; ++i)
    words[std::string("D").append(std::to_string(i))] = std::to_string(options.registers + i);
  for (int i = 0; i < kIntegerRegisters; ++i)
    words[std::string("I").append(std::to_string(i))] = std::to_string(options.registers + i);

  std::string text, line;
  std::istringstream lines(script);
  while (std::getline(lines, line)) {
    // a comment before the program would be a program of its own to the controller
    line.resize(std::min(line.find('#'), line.size()));
    if (line.find_first_not_of(" \r") == std::string::npos) continue;
    for (std::size_t begin = 0; (begin = line.find('@', begin)) != std::string::npos;) {
      const std::size_t end = line.find('@', begin + 1);
      const std::string word = end == std::string::npos ? "" : line.substr(begin + 1, end - begin - 1);
      const auto value = words.find(word);
      if (value == words.end())
        throw std::runtime_error(
            std::string("the control script has the unknown word @").append(word).append("@ in ").append(line));
      line.replace(begin, end + 1 - begin, value->second);
      begin += value->second.size();
    }
    text.append(line).append("\n");
    if (line.starts_with("def ")) text.append("  ").append(kScriptHeader).append("\n");
  }
  return text;
}

void upload_program(const std::string& program, const UrOptions& options) {
  TcpSocket socket("the secondary interface", options.address, options.script_port, options.timeout);
  const std::int64_t deadline = clock::monotonic_ns() + std::llround(options.timeout * 1e9);
  socket.send_all({reinterpret_cast<const std::uint8_t*>(program.data()), program.size()}, deadline);
}

}  // namespace mrroc::ur
