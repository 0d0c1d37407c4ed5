#include "cli/record/signals.hpp"

#include <algorithm>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <stdexcept>

#include "cli/record/recording_json.hpp"
#include "config/text/message_text.hpp"
#include "core/nearest_word.hpp"

namespace mrroc::cli::record {

namespace {

using Json = nlohmann::ordered_json;  // fields in the order of their message

constexpr std::size_t kMost = 64;  // signals below one name

/// A message of a recording, as `trace cat` prints it.
struct Printed {
  double time = 0;
  std::string topic;
  Json message;
};

template <class Take>
void for_each(const std::filesystem::path& file, const std::function<bool(const std::string&)>& wanted, Take take) {
  const auto parse = [&take](std::string_view line) {
    Json json = Json::parse(line);
    take(Printed{json["time"].get<double>(), json["topic"].get<std::string>(), std::move(json["message"])});
  };
  print_json(file, parse, wanted);
}

bool is_number(const Json& value) { return value.is_number() || value.is_boolean() || value.is_null(); }

double number_of(const Json& value) {
  if (value.is_boolean()) return value.get<bool>() ? 1 : 0;
  return value.get<double>();
}

/// Calls `take(name, number)` for every number below `value`.
template <class Take>
void for_each_number(const std::string& name, const Json& value, Take take) {
  if (is_number(value)) return take(name, value);
  if (value.is_array())
    for (std::size_t i = 0; i < value.size(); ++i)
      for_each_number(name + "[" + std::to_string(i) + "]", value[i], take);
  if (!value.is_object()) return;
  for (const auto& [key, child] : value.items()) {
    if (key == "stamp" || key == "header") continue;
    std::string field = name;
    field.append(".").append(key);
    for_each_number(field, child, take);
  }
}

/// A name without indices: "/arm/servo/current".
std::string without_indices(const std::string& name) {
  std::string text;
  bool inside = false;
  for (const char character : name) {
    inside = inside || character == '[';
    if (!inside) text += character;
    inside = inside && character != ']';
  }
  return text;
}

/// "/arm/servo.current[2]" with the separator that names are given with: "/arm/servo/current[2]".
std::string shown(const std::string& topic, const std::string& field) {
  return field.empty() ? topic : topic + "/" + field.substr(field[0] == '.' ? 1 : 0);
}

/// Whether `field` ("wrench.force.z", "current[2]") is `wanted` or below it; indices may be left out.
bool below(const std::string& field, const std::string& wanted) {
  const auto is_below = [&wanted](const std::string& name) {
    return name.starts_with(wanted) &&
           (name.size() == wanted.size() || name[wanted.size()] == '.' || name[wanted.size()] == '[');
  };
  return wanted.empty() || is_below(field) || is_below(without_indices(field));
}

/// What is wanted of a topic, as a field's name with points; nothing: the name is of another topic.
std::optional<std::string> field_of(const std::string& name, const std::string& topic) {
  if (name == topic) return "";
  if (!name.starts_with(topic + "/") || name.ends_with('/')) return std::nullopt;
  std::string field = name.substr(topic.size() + 1);
  std::replace(field.begin(), field.end(), '/', '.');
  return field;
}

[[noreturn]] void refuse(const std::filesystem::path& file, const std::string& name, const TimeSpan& span) {
  const std::vector<std::string> known = signal_names(file);
  const std::string nearest = core::nearest_word(without_indices(name), known);
  std::string why = "the recording has no such number";
  if (nearest == without_indices(name))
    why += " from " + config::number_text(span.from) + " s to " + config::number_text(span.to) + " s";
  else if (!nearest.empty())
    why += ", did you mean " + nearest + "?";
  throw std::runtime_error(file.string() + ": signal '" + name + "': " + why + " (`mrroc trace plot FILE` lists all)");
}

/// The signals below one name, as they are found.
class Found {
 public:
  explicit Found(std::string name) : name_(std::move(name)) {}

  void take(const Printed& printed) {
    const std::optional<std::string> wanted = field_of(name_, printed.topic);
    if (!wanted) return;
    for_each_number("", printed.message, [&](const std::string& name, const Json& value) {
      const std::string field = name.substr(1);
      if (below(field, *wanted) && !value.is_null()) add(shown(printed.topic, field), printed.time, number_of(value));
    });
  }
  const std::string& name() const noexcept { return name_; }
  std::vector<Signal>& signals() noexcept { return signals_; }

 private:
  void add(const std::string& name, double time, double value) {
    const auto [place, added] = places_.emplace(name, signals_.size());
    if (added) {
      if (signals_.size() == kMost)
        throw std::runtime_error("signal '" + name_ + "': more than " + std::to_string(kMost) +
                                 " numbers, expected the name of one field");
      signals_.push_back({name, {}, {}});
    }
    signals_[place->second].times.push_back(time);
    signals_[place->second].values.push_back(value);
  }

  std::string name_;
  std::vector<Signal> signals_;
  std::map<std::string, std::size_t> places_;
};

}  // namespace

std::vector<std::vector<Signal>> read_signals(const std::filesystem::path& file, const std::vector<std::string>& names,
                                              const TimeSpan& span) {
  std::vector<Found> found(names.begin(), names.end());
  const auto wanted = [&names](const std::string& topic) {
    return std::any_of(names.begin(), names.end(), [&](const std::string& name) { return field_of(name, topic); });
  };
  for_each(file, wanted, [&](const Printed& printed) {
    if (printed.time < span.from || printed.time > span.to) return;
    for (Found& each : found) each.take(printed);
  });
  std::vector<std::vector<Signal>> signals;
  for (Found& each : found) {
    if (each.signals().empty()) refuse(file, each.name(), span);
    signals.push_back(std::move(each.signals()));
  }
  return signals;
}

std::vector<std::string> signal_names(const std::filesystem::path& file) {
  std::map<std::string, std::vector<std::string>> names;  // by topic
  std::set<std::string> known;
  for_each(file, {}, [&](const Printed& printed) {
    for_each_number("", printed.message, [&](const std::string& field, const Json&) {
      const std::string name = shown(printed.topic, without_indices(field.substr(1)));
      if (known.insert(name).second) names[printed.topic].push_back(name);
    });
  });
  std::vector<std::string> all;
  for (const auto& [topic, own] : names) all.insert(all.end(), own.begin(), own.end());
  return all;
}

}  // namespace mrroc::cli::record
