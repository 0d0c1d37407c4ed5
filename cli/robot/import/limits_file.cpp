#include "cli/robot/import/limits_file.hpp"

#include <algorithm>

#include "config/table.hpp"
#include "config/text/message_text.hpp"
#include "core/nearest_word.hpp"

namespace mrroc::cli {

using config::ConfigurationError;
using config::Table;

namespace {

std::map<std::string, SourcedNumber> limits_of(const Table& table) {
  table.only({"velocity_max", "acceleration_max", "jerk_max", "torque_max", "position_min", "position_max"});
  std::map<std::string, SourcedNumber> limits;
  for (const std::string& key : table.keys()) {
    const bool position = key.starts_with("position_");
    const double value = position ? table.limit(key) : table.number(key);
    if (!position && !(value > 0)) table.fail(key, config::number_text(value) + " is not positive", "a number above 0");
    limits[key] = {value, "given: " + table.file().filename().string() + " line " + std::to_string(table.line(key))};
  }
  const auto min = limits.find("position_min"), max = limits.find("position_max");
  if (min != limits.end() && max != limits.end() && !(max->second.value > min->second.value))
    table.fail("position_max", config::number_text(max->second.value) + " is not above position_min",
               "a number above " + config::number_text(min->second.value));
  return limits;
}

}  // namespace

LimitsFile LimitsFile::load(const std::filesystem::path& file) {
  const Table table = Table::load(file);
  table.only({"all", "axes"});
  LimitsFile limits;
  limits.file_ = file;
  if (const auto all = table.optional_table("all")) limits.all_ = limits_of(*all);
  if (const auto axes = table.optional_table("axes")) {
    for (const std::string& name : axes->table_names()) {
      const Table axis = axes->table(name);
      limits.axes_[name] = limits_of(axis);
      limits.lines_[name] = axis.line();
    }
  }
  return limits;
}

void LimitsFile::check_names(const std::vector<std::string>& names) const {
  for (const auto& [name, line] : lines_) {
    if (std::find(names.begin(), names.end(), name) != names.end()) continue;
    const std::string nearest = core::nearest_word(name, names);
    throw ConfigurationError(file_, line, "axes." + name, "no axis " + config::in_quotes(name),
                             nearest.empty() ? config::alternatives(names) : "perhaps " + config::in_quotes(nearest));
  }
}

std::optional<SourcedNumber> LimitsFile::find(const std::string& axis, const std::string& key) const {
  const auto own = axes_.find(axis);
  const Limits& limits = own != axes_.end() && own->second.contains(key) ? own->second : all_;
  const auto found = limits.find(key);
  return found == limits.end() ? std::nullopt : std::optional(found->second);
}

}  // namespace mrroc::cli
