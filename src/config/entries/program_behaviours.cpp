#include "config/entries/program_behaviours.hpp"

#include <charconv>
#include <sstream>
#include <stdexcept>

#include "config/text/message_text.hpp"

namespace mrroc::config {

namespace {

/// Whether a field of this kind can have this number of bytes (FieldOf).
bool fits(const MessageFieldEntry& field) {
  switch (field.kind) {
    case FieldKind::number:
      return field.size == FieldOf<double>::kSize;
    case FieldKind::integer:
      return field.size == FieldOf<int>::kSize;
    case FieldKind::truth:
      return field.size == FieldOf<bool>::kSize;
    case FieldKind::text:
      return field.size > 0;
    case FieldKind::vector:
      return field.size > 0 && field.size % sizeof(double) == 0;
    case FieldKind::joints:
      return field.size == FieldOf<JointVector>::kSize;
    case FieldKind::pose:
      return field.size == FieldOf<Pose>::kSize;
  }
  return false;
}

/// `x:number:8`
MessageFieldEntry read_field(const std::string& word) {
  const std::size_t first = word.find(':'), second = word.find(':', first + 1);
  if (first != std::string::npos && second != std::string::npos) {
    const std::string kind = word.substr(first + 1, second - first - 1);
    MessageFieldEntry field{word.substr(0, first), FieldKind::number, 0};
    const char* const end = word.data() + word.size();
    const bool size = std::from_chars(word.data() + second + 1, end, field.size).ptr == end;
    for (int known = 0; known <= static_cast<int>(FieldKind::pose); ++known) {
      field.kind = static_cast<FieldKind>(known);
      if (size && kind == describe(field.kind) && fits(field)) return field;
    }
  }
  throw std::runtime_error(in_quotes(word) + " is not a field, expected name:kind:bytes");
}

/// Throws unless the fields together fit a parcel.
void check_size(const MessageSchema& schema) {
  std::size_t left = Message::kCapacity;
  for (const MessageFieldEntry& field : schema.fields) {
    if (field.size > left)
      throw std::runtime_error("the behaviour " + in_quotes(schema.label) + " is too large, expected at most " +
                               std::to_string(Message::kCapacity) + " bytes");
    left -= field.size;
  }
}

}  // namespace

std::string to_text(const ProgramBehaviours& behaviours) {
  std::string text;
  for (const MessageSchema& behaviour : behaviours.on) {
    text += "on " + behaviour.label;
    for (const MessageFieldEntry& field : behaviour.fields)
      text += " " + field.name + ":" + describe(field.kind) + ":" + std::to_string(field.size);
    text += "\n";
  }
  for (const std::string& label : behaviours.tells) text += "tells " + label + "\n";
  return text;
}

ProgramBehaviours read_behaviours(const std::string& text) {
  ProgramBehaviours behaviours;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string what, label;
    words >> what >> label;
    if (label.empty() || (what != "on" && what != "tells"))
      throw std::runtime_error(in_quotes(line) + " is not a behaviour, expected 'on LABEL ...' or 'tells LABEL'");
    if (what == "tells") {
      behaviours.tells.push_back(label);
      continue;
    }
    MessageSchema schema{label, {}};
    for (std::string word; words >> word;) schema.fields.push_back(read_field(word));
    check_size(schema);
    behaviours.on.push_back(schema);
  }
  return behaviours;
}

std::string to_text(const ProgramsByRobot& programs) {
  std::string text;
  for (const auto& [robot, behaviours] : programs) {
    std::istringstream lines(to_text(behaviours));
    for (std::string line; std::getline(lines, line);) text.append(robot).append(" ").append(line).append("\n");
  }
  return text;
}

ProgramsByRobot read_programs(const std::string& text) {
  std::map<std::string, std::string> texts;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    const std::size_t end = line.find(' ');
    if (end == std::string::npos) throw std::runtime_error(in_quotes(line) + " is not a behaviour of a robot");
    texts[line.substr(0, end)] += line.substr(end + 1) + "\n";
  }
  ProgramsByRobot programs;
  for (const auto& [robot, behaviours] : texts) programs[robot] = read_behaviours(behaviours);
  return programs;
}

}  // namespace mrroc::config
