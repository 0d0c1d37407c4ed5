#include "config/program_behaviours.hpp"

#include <array>
#include <charconv>
#include <cstdio>
#include <memory>
#include <sstream>
#include <stdexcept>

#include "config/message_text.hpp"

namespace mrroc::config {

namespace {

constexpr std::array kKinds{FieldKind::number, FieldKind::integer, FieldKind::truth, FieldKind::text,
                            FieldKind::vector, FieldKind::joints,  FieldKind::pose};

/// `x:number:8`
MessageFieldEntry read_field(const std::string& word) {
  const std::size_t first = word.find(':'), second = word.find(':', first + 1);
  if (first != std::string::npos && second != std::string::npos) {
    const std::string kind = word.substr(first + 1, second - first - 1);
    MessageFieldEntry field{word.substr(0, first), FieldKind::number, 0};
    const char* const end = word.data() + word.size();
    const bool size = std::from_chars(word.data() + second + 1, end, field.size).ptr == end;
    for (const FieldKind known : kKinds) {
      field.kind = known;
      if (size && kind == describe(known)) return field;
    }
  }
  throw std::runtime_error(in_quotes(word) + " is no field, expected name:kind:bytes");
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
      throw std::runtime_error(in_quotes(line) + " is no behaviour, expected 'on LABEL ...' or 'tells LABEL'");
    if (what == "tells") {
      behaviours.tells.push_back(label);
      continue;
    }
    MessageSchema schema{label, {}};
    for (std::string word; words >> word;) schema.fields.push_back(read_field(word));
    behaviours.on.push_back(schema);
  }
  return behaviours;
}

ProgramBehaviours behaviours_of(const std::filesystem::path& program) {
  std::string quoted;  // for the shell
  for (const char c : program.string()) quoted += c == '\'' ? std::string{"'\\''"} : std::string{c};
  const std::string command = "'" + quoted + "' --behaviours </dev/null";
  const auto close = [](FILE* pipe) { pclose(pipe); };
  std::unique_ptr<FILE, decltype(close)> pipe(popen(command.c_str(), "re"), close);
  if (pipe == nullptr) throw std::runtime_error("cannot be started");
  std::string text;
  std::array<char, 4096> part{};
  while (const std::size_t size = fread(part.data(), 1, part.size(), pipe.get())) text.append(part.data(), size);
  if (pclose(pipe.release()) != 0)
    throw std::runtime_error("does not tell its behaviours when called with --behaviours");
  return read_behaviours(text);
}

}  // namespace mrroc::config
