#include "canopen/eds_sections.hpp"

#include <algorithm>

#include "core/shown_text.hpp"
#include "core/text_lines.hpp"

namespace mrroc::canopen {

namespace {

std::string described(const std::string& file, int line, const std::string& where, const std::string& problem,
                      const std::string& expected) {
  std::string text = file;
  if (line > 0) text += ":" + std::to_string(line);
  text += ": ";
  if (!where.empty()) text += where + ": ";
  return core::shown(text + problem + ", expected " + expected);
}

std::string_view value_of(std::string_view text) {
  text = core::trimmed(text);
  const std::size_t end = text.starts_with('"') ? text.find('"', 1) : std::string_view::npos;
  if (end != std::string_view::npos) {
    const std::string_view behind = core::trimmed(text.substr(end + 1));
    if (behind.empty() || behind.front() == ';') return core::trimmed(text.substr(1, end - 1));
  }
  return core::trimmed(core::without_comment(text, ';'));
}

class Reader {
 public:
  explicit Reader(const std::string& file) : file_(file) {}

  void take(std::string_view line, int number) {
    line = core::trimmed(line);
    if (line.empty() || line.front() == ';' || line.front() == '#') return;
    line.front() == '[' ? take_section(line, number) : take_key(line, number);
  }
  std::vector<EdsSection> sections;

 private:
  void take_section(std::string_view line, int number) {
    const std::size_t end = line.find(']');
    const std::string_view behind = end == std::string_view::npos ? line : core::trimmed(line.substr(end + 1));
    if (!behind.empty() && behind.front() != ';' && behind.front() != '#')
      throw EdsError(file_, number, "", in_quotes(line) + (behind == line ? " has no end" : " has more behind its end"),
                     "[NAME]");
    sections.push_back({small_letters(core::trimmed(line.substr(1, end - 1))), {}, number});
  }

  void take_key(std::string_view line, int number) {
    const std::size_t equals = line.find('=');
    if (equals == std::string_view::npos || sections.empty())
      throw EdsError(file_, number, "", in_quotes(line), sections.empty() ? "a section [NAME] first" : "KEY=VALUE");
    sections.back().lines.push_back(
        {small_letters(core::trimmed(line.substr(0, equals))), std::string(value_of(line.substr(equals + 1))), number});
  }

  const std::string& file_;
};

}  // namespace

EdsError::EdsError(const std::string& file, int line, const std::string& where, const std::string& problem,
                   const std::string& expected)
    : std::runtime_error(described(file, line, where, problem, expected)) {}

const EdsLine* EdsSection::find(std::string_view key) const {
  const auto found = std::find_if(lines.begin(), lines.end(), [key](const EdsLine& line) { return line.key == key; });
  return found == lines.end() ? nullptr : &*found;
}

std::string in_quotes(std::string_view text) { return std::string("'").append(text).append("'"); }

std::string small_letters(std::string_view text) {
  std::string result(text);
  for (char& letter : result)
    if (letter >= 'A' && letter <= 'Z') letter = static_cast<char>(letter - 'A' + 'a');
  return result;
}

std::vector<EdsSection> read_eds_sections(std::string_view text, const std::string& file) {
  Reader reader(file);
  try {
    for (core::TextLines lines(text); lines.next();) reader.take(lines.line(), lines.number());
  } catch (const core::TextError& error) {
    throw EdsError(file, error.line, "", error.problem, error.expected);
  }
  return std::move(reader.sections);
}

}  // namespace mrroc::canopen
