#include "cli/hosts/agent_protocol.hpp"

#include <stdexcept>

#include "config/drives/drive_objects.hpp"
#include "config/drives/io_table.hpp"
#include "config/robot_parameters_file.hpp"
#include "config/text/file_text.hpp"
#include "core/number_text.hpp"
#include "mrroc/fnv.hpp"

namespace mrroc::cli {

namespace {

std::string hash_of(const std::filesystem::path& file) {
  return core::hexadecimal(Fnv1a{}.add(config::read_file(file)).value());
}

int number_in(const std::string& line, std::int64_t most) {
  const auto number = whole_number(split_word(line).second);
  if (!number || *number < 0 || *number > most) throw std::runtime_error("order '" + line + "': expected a number");
  return static_cast<int>(*number);
}

}  // namespace

std::vector<std::string> to_lines(const AgentOrder& order) {
  std::vector<std::string> lines{"host " + order.host, "deployment " + order.deployment.string()};
  for (const auto& [key, hash] : order.files)
    lines.push_back(std::string("file ").append(key).append(" ").append(hash));
  lines.push_back("domain " + std::to_string(order.domain));
  for (const std::string& machine : order.machines) lines.push_back("machine " + machine);
  lines.push_back("beat_port " + std::to_string(order.beat_port));
  lines.push_back("key " + to_hex(order.key));
  if (order.record) lines.emplace_back("record");
  if (order.black_box) lines.emplace_back("black_box");
  if (!order.motion.empty()) lines.push_back("motion " + order.motion.string());
  return lines;
}

AgentOrder order_of_lines(const std::vector<std::string>& lines) {
  AgentOrder order;
  bool has_key = false;
  for (const std::string& line : lines) {
    const auto [word, text] = split_word(line);
    if (word == "host") {
      order.host = text;
    } else if (word == "deployment") {
      order.deployment = text;
    } else if (word == "file") {
      order.files.push_back(split_word(text));
    } else if (word == "domain") {
      order.domain = number_in(line, 230);
    } else if (word == "machine") {
      order.machines.push_back(text);
    } else if (word == "beat_port") {
      order.beat_port = number_in(line, 65535);
    } else if (word == "key") {
      const auto key = key_of_hex(text);
      if (!key) throw std::runtime_error("order 'key': expected 64 hexadecimal digits");
      order.key = *key;
      has_key = true;
    } else if (word == "record") {
      order.record = true;
    } else if (word == "black_box") {
      order.black_box = true;
    } else if (word == "motion") {
      order.motion = text;
    } else {
      throw std::runtime_error("order '" + line + "' is unknown: the runner has another version");
    }
  }
  if (order.host.empty() || order.deployment.empty() || order.machines.empty() || order.beat_port == 0 || !has_key)
    throw std::runtime_error("the order is incomplete: `mrroc agent` is started by `mrroc run`, not by hand");
  return order;
}

std::string to_text(const recording::RecordedStep& step) {
  return std::to_string(step.tick) + " " + core::hexadecimal(step.cdr);
}

std::optional<recording::RecordedStep> step_of(const std::string& text) {
  const auto [number, digits] = split_word(text);
  const auto tick = core::to_whole<Tick>(number);
  auto bytes = core::bytes_of_hexadecimal(digits);
  if (!tick || !bytes) return std::nullopt;
  return recording::RecordedStep{*tick, std::move(*bytes)};
}

std::pair<std::string, std::string> split_word(const std::string& line) {
  const std::size_t space = line.find(' ');
  if (space == std::string::npos) return {line, ""};
  return {line.substr(0, space), line.substr(space + 1)};
}

std::optional<std::int64_t> whole_number(const std::string& text) { return core::to_whole<std::int64_t>(text); }

std::vector<std::pair<std::string, std::filesystem::path>> input_files(const config::Deployment& deployment) {
  std::vector<std::pair<std::string, std::filesystem::path>> files{{"deployment", deployment.file}};
  for (const std::filesystem::path& file : deployment.calibrations) files.emplace_back("deployment.calibration", file);
  if (!deployment.mp.states.empty()) files.emplace_back("mp.states", deployment.mp.states);
  if (deployment.sim) files.emplace_back("sim.scene", deployment.sim->scene);
  for (const config::RobotEntry& robot : deployment.robots) {
    const std::string key = std::string("robots.").append(robot.name);
    files.emplace_back(key + (robot.parameters.empty() ? ".type" : ".parameters"), robot.files().parameters);
    if (robot.can) files.emplace_back(key + ".can.drives", robot.can->drives);
  }
  for (const config::SensorEntry& sensor : deployment.sensors)
    if (!sensor.replay.empty()) files.emplace_back("sensors." + sensor.name + ".replay", sensor.replay);
  return files;
}

std::vector<std::pair<std::string, std::string>> files_of(const config::Deployment& deployment) {
  std::vector<std::pair<std::string, std::string>> files;
  for (const auto& [key, file] : input_files(deployment)) files.emplace_back(key, hash_of(file));
  for (const config::RobotEntry& robot : deployment.robots) {
    if (!robot.can) continue;
    const std::string key = std::string("robots.").append(robot.name);
    files.emplace_back(key + ".can.drives: eds",
                       hash_of(config::eds_file(config::Table::load(robot.can->drives), config::kGeneralDriveEds)));
    if (robot.can->io.empty()) continue;
    for (const std::filesystem::path& file : config::io_eds_files(robot.can->io))
      files.emplace_back(key + ".can.io: eds", hash_of(file));
  }
  return files;
}

}  // namespace mrroc::cli
