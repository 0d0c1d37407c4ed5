#include "sim/scene/names.hpp"

#include <algorithm>
#include <map>

#include "config/table.hpp"
#include "config/text/message_text.hpp"

namespace mrroc::sim {

namespace {

using config::in_quotes;

/// The names that share one space: all joints, all sensors, ...; empty: its elements have no names of their own.
std::string kind_of(const std::string& section, const std::string& element) {
  if (element == "freejoint") return "joint";
  for (const char* const one : {"equality", "tendon", "actuator", "sensor"})
    if (section == one) return one;
  if (section == "worldbody" || section == "asset" || section == "contact" || section == "custom") return element;
  return "";
}

std::string place_of(const Element& element) {
  return element.origin.file->filename().string() + ":" + std::to_string(element.origin.line);
}

class Names {
 public:
  explicit Names(const std::vector<std::string>& robots) : robots_(robots) {}

  void add(const std::string& section, const Element& element) {
    const std::string kind = kind_of(section, element.name);
    const std::string* const name = element.find("name");
    if (name != nullptr && !name->empty() && !kind.empty()) {
      const auto [found, added] = found_.emplace(std::pair{kind, *name}, &element);
      if (!added) refuse(kind, *name, *found->second, element);
    }
    // the parts of other sections' elements have no names, only references
    if (section == "worldbody")
      for (const Element& child : element.children) add(section, child);
  }

 private:
  const std::string* robot_of(const std::string& name) const {
    const auto owns = [&](const std::string& robot) { return name == robot || name.starts_with(robot + "/"); };
    const auto found = std::find_if(robots_.begin(), robots_.end(), owns);
    return found == robots_.end() ? nullptr : &*found;
  }

  /// A robot's file is valid on its own, so the scene's element must change.
  [[noreturn]] void refuse(const std::string& kind, const std::string& name, const Element& first,
                           const Element& second) const {
    const std::string* const robot = robot_of(name);
    const bool same_file = *first.origin.file == *second.origin.file;
    const Element& at = robot != nullptr && !same_file ? first : second;  // the scene comes before the robots
    const Element& other = &at == &first ? second : first;
    throw config::ConfigurationError(
        *at.origin.file, at.origin.line, kind,
        "repeated name " + in_quotes(name) + ", " +
            (robot != nullptr && !same_file ? "which robot " + in_quotes(*robot) + " has in " : "the first is in ") +
            place_of(other),
        robot != nullptr && !same_file ? "a name that does not begin with that of a robot" : "a name for each");
  }

  const std::vector<std::string>& robots_;
  std::map<std::pair<std::string, std::string>, const Element*> found_;
};

}  // namespace

void check_names(const Element& root, const std::vector<std::string>& robots) {
  Names names(robots);
  for (const Element& section : root.children)
    for (const Element& element : section.children) names.add(section.name, element);
}

}  // namespace mrroc::sim
