#include "config/text/calibration_text.hpp"

#include <algorithm>
#include <optional>

#include "config/entries/named_file.hpp"
#include "config/table.hpp"
#include "config/text/file_text.hpp"
#include "config/text/message_text.hpp"
#include "config/text/toml_text.hpp"

namespace mrroc::config {

namespace {

std::optional<toml::table> parsed(const std::string& text) {
  try {
    return toml::parse(text);
  } catch (const toml::parse_error&) {
    return std::nullopt;
  }
}

/// Puts the keys of a calibration file into those of the deployment.
void apply(toml::table& deployment, const std::filesystem::path& file) {
  const std::string text = read_file(file);
  const Table calibration = Table::parse(file, text);
  calibration.only({"robots", "sensors"});
  const toml::table values = toml::parse(text);
  for (const char* kind : {"robots", "sensors"}) {
    const auto devices = calibration.optional_table(kind);
    if (!devices) continue;
    toml::table* const known = deployment[kind].as_table();
    std::vector<std::string> names;
    if (known != nullptr)
      for (const auto& [name, node] : *known) names.emplace_back(name.str());
    for (const std::string& name : devices->table_names()) {
      toml::table* const device = known == nullptr ? nullptr : (*known)[name].as_table();
      if (device == nullptr) devices->fail(name, "is not in the deployment", alternatives(names));
      for (const auto& [key, node] : *values[kind][name].as_table()) device->insert_or_assign(key, node);
    }
  }
}

}  // namespace

std::vector<std::filesystem::path> calibration_files(const std::filesystem::path& file, const std::string& text) {
  std::vector<std::filesystem::path> files;
  const Table deployment = Table::parse(file, text).table("deployment");
  for (const std::string& name : deployment.texts("calibration")) {
    files.push_back(beside(file, name));
    if (!std::filesystem::is_regular_file(files.back()))
      deployment.fail("calibration", "no file " + in_quotes(files.back().string()),
                      "a file that `mrroc calibrate` has written");
  }
  return files;
}

std::string with_calibrations(const std::filesystem::path& file, const std::string& text) {
  std::optional<toml::table> root = parsed(text);
  if (!root || !(*root)["deployment"].is_table() || !(*root)["deployment"]["calibration"]) return text;
  for (const std::filesystem::path& calibration : calibration_files(file, text)) apply(*root, calibration);
  (*root)["deployment"].as_table()->erase("calibration");
  return toml_text(*root);
}

std::optional<CalibrationLine> calibration_line(const std::filesystem::path& file, const std::string& text,
                                                std::string_view key) {
  std::optional<CalibrationLine> last;
  for (const std::filesystem::path& calibration : calibration_files(file, text)) {
    const toml::table values = toml::parse(read_file(calibration));
    const toml::node* node = &values;
    for (std::string_view rest = key.substr(0, key.find('[')); node != nullptr && !rest.empty();) {
      const std::string_view name = rest.substr(0, rest.find('.'));
      rest.remove_prefix(std::min(rest.size(), name.size() + 1));
      node = node->is_table() ? node->as_table()->get(name) : nullptr;
    }
    if (node != nullptr && node != &values) last = {calibration, static_cast<int>(node->source().begin.line)};
  }
  return last;
}

std::string for_calibration(const std::string& text, const CalibrationTask& task) {
  toml::table root = toml::parse(text);
  root.erase("events");
  root.erase("answers");
  root.insert_or_assign("mp", toml::table{{"states", task.states.string()}});
  toml::table& robots = *root["robots"].as_table();
  for (auto&& [name, node] : robots) {
    toml::table& entry = *node.as_table();
    entry.erase("program");
    if (name.str() == task.robot) entry.insert_or_assign("program", task.program);
  }
  for (const auto& [key, value] : task.sensor_keys)
    root["sensors"][task.sensor].as_table()->insert_or_assign(key, value);
  return toml_text(root);
}

}  // namespace mrroc::config
