#include "canopen/eds_file.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <fstream>
#include <iterator>
#include <optional>
#include <vector>

namespace mrroc::canopen {

namespace {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";  // of UTF-8: some editors put it first

std::string small(std::string_view text) {
  std::string result(text);
  std::transform(result.begin(), result.end(), result.begin(),
                 [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  return result;
}

std::string_view trimmed(std::string_view text) {
  const auto begin = text.find_first_not_of(" \t\r");
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(" \t\r") - begin + 1);
}

std::string in_quotes(std::string_view text) { return std::string("'").append(text).append("'"); }

/// A whole number: decimal, or hexadecimal after 0x.
std::optional<std::uint32_t> number_of(std::string_view text) {
  const bool hexadecimal = text.size() > 2 && text[0] == '0' && (text[1] == 'x' || text[1] == 'X');
  if (hexadecimal) text.remove_prefix(2);
  std::uint32_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value, hexadecimal ? 16 : 10);
  if (error != std::errc{} || end != text.data() + text.size()) return {};
  return value;
}

/// "6040" or "1018sub1", digits hexadecimal; nothing: the section describes no value.
std::optional<Object> object_of_section(const std::string& section) {
  if (section.size() < 4) return {};
  unsigned index = 0, sub = 0;
  const char* const digits = section.data();
  if (std::from_chars(digits, digits + 4, index, 16).ptr != digits + 4) return {};
  if (section.size() > 4) {
    if (section.substr(4, 3) != "sub" || section.size() > 9) return {};
    const char* const end = digits + section.size();
    if (section.size() == 7 || std::from_chars(digits + 7, end, sub, 16).ptr != end || sub > 0xff) return {};
  }
  return Object{static_cast<std::uint16_t>(index), static_cast<std::uint8_t>(sub)};
}

bool is_access(std::string_view text) {
  return text == "ro" || text == "wo" || text == "rw" || text == "rwr" || text == "rww" || text == "const";
}

struct Line {
  std::string key;
  std::string value;
  int number = 0;
};

struct Section {
  std::string name;  ///< in small letters
  std::vector<Line> lines;
  int number = 0;

  const Line* find(std::string_view key) const {
    const auto found = std::find_if(lines.begin(), lines.end(), [key](const Line& line) { return line.key == key; });
    return found == lines.end() ? nullptr : &*found;
  }
};

class Parser {
 public:
  Parser(std::string_view text, std::string name) : text_(text), name_(std::move(name)) {}

  std::vector<Section> sections() const {
    std::vector<Section> all;
    int number = 0;
    std::string_view rest = text_;
    if (rest.starts_with(kByteOrderMark)) rest.remove_prefix(kByteOrderMark.size());
    while (!rest.empty()) {
      const std::size_t end = std::min(rest.find('\n'), rest.size());
      const std::string_view line = trimmed(rest.substr(0, end));
      rest.remove_prefix(std::min(end + 1, rest.size()));
      ++number;
      if (line.empty() || line.front() == ';' || line.front() == '#') continue;
      if (line.front() == '[') {
        if (line.back() != ']') fail(number, "", in_quotes(line) + " has no end", "[NAME]");
        all.push_back({small(trimmed(line.substr(1, line.size() - 2))), {}, number});
        continue;
      }
      const std::size_t equals = line.find('=');
      if (equals == std::string_view::npos || all.empty())
        fail(number, "", in_quotes(line), all.empty() ? "a section [NAME] first" : "KEY=VALUE");
      all.back().lines.push_back(
          {small(trimmed(line.substr(0, equals))), std::string(trimmed(line.substr(equals + 1))), number});
    }
    return all;
  }

  ObjectEntry entry(const Section& section) const {
    ObjectEntry entry;
    const Line* const name = section.find("parametername");
    if (name == nullptr || name->value.empty()) fail(section.number, section.name, "no ParameterName", "one");
    entry.name = name->value;
    if (const Line* const line = section.find("datatype")) {
      const auto type = number_of(line->value);
      if (!type || *type == 0 || *type > 0xffff)
        fail(line->number, section.name + ": DataType", in_quotes(line->value), "a type's number, as 0x0007");
      entry.type = static_cast<DataType>(*type);
    }
    if (const Line* const line = section.find("accesstype")) {
      entry.access = small(line->value);
      if (!is_access(entry.access))
        fail(line->number, section.name + ": AccessType", in_quotes(line->value), "ro, wo, rw, rwr, rww or const");
    }
    if (const Line* const line = section.find("defaultvalue")) entry.default_value = line->value;
    if (const Line* const line = section.find("pdomapping")) entry.mappable = line->value == "1";
    return entry;
  }

  /// How many sub-values a section describes at once (CompactSubObj); 0: it is of one value, or each has its own.
  std::uint32_t parts(const Section& section) const {
    const Line* const line = section.find("compactsubobj");
    if (line == nullptr) return 0;
    const auto count = number_of(line->value);
    if (!count || *count > 0xfe)
      fail(line->number, section.name + ": CompactSubObj", in_quotes(line->value), "a number up to 254");
    return *count;
  }

 private:
  [[noreturn]] void fail(int line, const std::string& where, const std::string& problem,
                         const std::string& expected) const {
    throw EdsError(name_ + ":" + std::to_string(line) + ": " + where + (where.empty() ? "" : ": ") + problem +
                   ", expected " + expected);
  }

  std::string_view text_;
  std::string name_;
};

/// What a section says of single sub-values, by their numbers; empty: there is no such section.
std::map<std::uint32_t, std::string> listed(const std::vector<Section>& sections, const std::string& name) {
  std::map<std::uint32_t, std::string> found;
  for (const Section& section : sections) {
    if (section.name != name) continue;
    for (const Line& line : section.lines)
      if (const auto number = number_of(line.key)) found.emplace(*number, line.value);
  }
  return found;
}

}  // namespace

EdsFile EdsFile::load(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream || std::filesystem::is_directory(file))
    throw EdsError(file.string() + ": cannot be read, expected an EDS file");
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  return parse(text, file.string());
}

EdsFile EdsFile::parse(std::string_view text, const std::string& name) {
  const Parser parser(text, name);
  EdsFile file;
  std::map<std::uint16_t, std::string> parents;
  const std::vector<Section> sections = parser.sections();
  for (const Section& section : sections) {
    if (section.name == "deviceinfo")
      if (const Line* const product = section.find("productname")) file.product_ = product->value;
    const auto object = object_of_section(section.name);
    if (!object) continue;
    ObjectEntry entry = parser.entry(section);
    const std::uint32_t parts = section.name.size() == 4 ? parser.parts(section) : 0;
    const bool has_subs = section.name.size() == 4 && section.find("accesstype") == nullptr;
    if (parts > 0) {
      file.add_parts(entry, object->index, parts, listed(sections, section.name + "name"),
                     listed(sections, section.name + "value"));
    } else if (has_subs) {
      parents[object->index] = entry.name;
    } else {
      file.add(*object, section.name.size() > 4 ? parents[object->index] : "", std::move(entry));
    }
  }
  return file;
}

void EdsFile::add(Object object, const std::string& parent, ObjectEntry entry) {
  names_.emplace(small(parent.empty() ? entry.name : parent + "/" + entry.name), object);
  entries_.emplace(object, std::move(entry));
}

/// CiA 306-1: they differ in nothing but their names and default values, if in those.
void EdsFile::add_parts(const ObjectEntry& all, std::uint16_t index, std::uint32_t count,
                        const std::map<std::uint32_t, std::string>& names,
                        const std::map<std::uint32_t, std::string>& values) {
  add({index, 0}, all.name, {"NrOfObjects", DataType::unsigned8, "ro", std::to_string(count), false});
  for (std::uint32_t i = 1; i <= count; ++i) {
    ObjectEntry entry = all;
    const auto name = names.find(i);
    entry.name = name == names.end() ? all.name + std::to_string(i) : name->second;
    if (const auto value = values.find(i); value != values.end()) entry.default_value = value->second;
    add({index, static_cast<std::uint8_t>(i)}, all.name, std::move(entry));
  }
}

const ObjectEntry* EdsFile::find(Object object) const noexcept {
  const auto found = entries_.find(object);
  return found == entries_.end() ? nullptr : &found->second;
}

Object EdsFile::object(std::string_view text) const {
  const std::string wanted = small(trimmed(text));
  if (const auto named = names_.find(wanted); named != names_.end()) return named->second;
  if (wanted.starts_with("0x")) {
    const std::size_t colon = wanted.find(':');
    const auto index = number_of(wanted.substr(0, colon));
    const auto sub = colon == std::string::npos ? std::optional<std::uint32_t>(0) : number_of(wanted.substr(colon + 1));
    if (index && sub && *index <= 0xffff && *sub <= 0xff) {
      const Object object{static_cast<std::uint16_t>(*index), static_cast<std::uint8_t>(*sub)};
      if (find(object) != nullptr) return object;
      throw std::invalid_argument("object " + to_text(object) + " is not in the EDS file");
    }
  }
  std::string near;
  for (const auto& [name, object] : names_)
    if (!wanted.empty() && (name.find(wanted) != std::string::npos || wanted.find(name) != std::string::npos))
      near += (near.empty() ? "" : ", ") + entries_.at(object).name;
  throw std::invalid_argument(in_quotes(text) + " is no object of the EDS file, expected a name of it" +
                              (near.empty() ? "" : " (" + near + ")") + " or an address like 0x6040 or 0x1018:1");
}

}  // namespace mrroc::canopen
