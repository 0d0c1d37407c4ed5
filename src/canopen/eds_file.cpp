#include "canopen/eds_file.hpp"

#include <algorithm>
#include <charconv>
#include <fstream>
#include <iterator>
#include <optional>
#include <set>
#include <stdexcept>

#include "canopen/default_value.hpp"
#include "core/number_text.hpp"
#include "core/shown_text.hpp"
#include "core/text_lines.hpp"

namespace mrroc::canopen {

namespace {

constexpr std::uint32_t kDomain = 2, kDefinedStructure = 6, kVariable = 7, kArray = 8, kRecord = 9;
constexpr std::uint32_t kGreatestObjectType = kRecord;

std::optional<std::uint32_t> number_of(std::string_view text) {
  const auto value = core::to_literal(core::trimmed(text.substr(0, text.find(';'))));
  if (!value || *value > 0xffffffff) return {};
  return static_cast<std::uint32_t>(*value);
}

/// "6040" or "1018sub1", digits hexadecimal; nothing: the section does not describe a value.
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

/// A name that begins as the address of an object does, of a section with the keys of a value: a misspelt address, not
/// an addition of a maker or a part of a module ("M1SubExt6000").
bool is_misspelt(const EdsSection& section) {
  const bool begins_so = section.name.starts_with("0x") || section.name.find_first_not_of("0123456789abcdef") >= 4;
  return begins_so && (section.find("datatype") != nullptr || section.find("accesstype") != nullptr);
}

bool is_access(std::string_view text) {
  return text == "ro" || text == "wo" || text == "rw" || text == "rwr" || text == "rww" || text == "const";
}

/// Reads the sections of objects.
class Parser {
 public:
  explicit Parser(const std::string& file) : file_(file) {}

  ObjectEntry entry(const EdsSection& section) const {
    ObjectEntry entry;
    entry.name = name(section);
    const bool domain = number(section, "objecttype", "ObjectType", kVariable, kGreatestObjectType) == kDomain;
    entry.type = type(section, domain);
    entry.access = access(section, domain);
    entry.default_value = value(section, "defaultvalue", "DefaultValue", entry.type);
    entry.parameter_value = value(section, "parametervalue", "ParameterValue", entry.type);
    entry.mappable = number(section, "pdomapping", "PDOMapping", 0, 1) == 1;
    return entry;
  }

  std::string name(const EdsSection& section) const {
    check_keys(section);
    const EdsLine* const name = section.find("parametername");
    if (name == nullptr || name->value.empty()) fail(section.number, section.name, "no ParameterName", "one");
    return name->value;
  }

  /// Whether the section of an object represents its parts.
  bool has_parts(const EdsSection& section, bool sub_sections) const {
    const std::uint32_t type = number(section, "objecttype", "ObjectType", kVariable, kGreatestObjectType);
    const std::uint32_t parts = number(section, "subnumber", "SubNumber", 0, 0xff);
    if (sub_sections || parts > 0 || type == kRecord || type == kArray || type == kDefinedStructure) return true;
    return section.find("accesstype") == nullptr && section.find("datatype") == nullptr && type == kVariable &&
           section.find("objecttype") == nullptr;
  }

  /// Number of sub-values that a section describes at once (CompactSubObj); 0: one value, or each has its own section.
  std::uint32_t parts(const EdsSection& section) const {
    return number(section, "compactsubobj", "CompactSubObj", 0, 0xfe);
  }

  void check_value(const EdsSection& section, const EdsLine& line, const std::string& key, DataType type) const {
    if (const std::string expected = expected_value(line.value, type); !expected.empty())
      fail(line.number, section.name + ": " + key, in_quotes(line.value), expected);
  }

  [[noreturn]] void fail(int line, const std::string& where, const std::string& problem,
                         const std::string& expected) const {
    throw EdsError(file_, line, where, problem, expected);
  }

 private:
  void check_keys(const EdsSection& section) const {
    for (const EdsLine& line : section.lines) {
      const EdsLine& first = *section.find(line.key);
      if (first.value != line.value)
        fail(line.number, section.name + ": " + line.key,
             in_quotes(line.value) + ", but " + in_quotes(first.value) + " in line " + std::to_string(first.number),
             "each key once");
    }
  }

  /// A whole number that is 0 to `greatest`; `usual` when it is missing or blank.
  std::uint32_t number(const EdsSection& section, std::string_view key, const std::string& shown_key,
                       std::uint32_t usual, std::uint32_t greatest) const {
    const EdsLine* const line = section.find(key);
    if (line == nullptr || line->value.empty()) return usual;
    const auto value = number_of(line->value);
    if (!value || *value > greatest)
      fail(line->number, section.name + ": " + shown_key, in_quotes(line->value),
           "a number up to " + std::to_string(greatest));
    return *value;
  }

  DataType type(const EdsSection& section, bool domain) const {
    constexpr const char* kExpected = "a type's number, as 0x0007";
    const EdsLine* const line = section.find("datatype");
    if (domain && (line == nullptr || line->value.empty())) return DataType::domain;
    if (line == nullptr) fail(section.number, section.name, "no DataType", kExpected);
    const auto type = number_of(line->value);
    if (!type || *type == 0 || *type > 0xffff)
      fail(line->number, section.name + ": DataType", in_quotes(line->value), kExpected);
    return static_cast<DataType>(*type);
  }

  std::string access(const EdsSection& section, bool domain) const {
    constexpr const char* kExpected = "ro, wo, rw, rwr, rww or const";
    const EdsLine* const line = section.find("accesstype");
    if (domain && (line == nullptr || line->value.empty())) return "rw";
    if (line == nullptr) fail(section.number, section.name, "no AccessType", kExpected);
    std::string access = small_letters(core::trimmed(line->value.substr(0, line->value.find(';'))));
    if (!is_access(access)) fail(line->number, section.name + ": AccessType", in_quotes(line->value), kExpected);
    return access;
  }

  std::string value(const EdsSection& section, std::string_view key, const std::string& shown_key,
                    DataType type) const {
    const EdsLine* const line = section.find(key);
    if (line == nullptr) return "";
    check_value(section, *line, shown_key, type);
    return line->value;
  }

  const std::string& file_;
};

/// The lines of a section about single sub-values, by their numbers; empty without such a section.
std::map<std::uint32_t, const EdsLine*> listed(const EdsSection* section) {
  std::map<std::uint32_t, const EdsLine*> found;
  if (section == nullptr) return found;
  for (const EdsLine& line : section->lines)
    if (const auto number = number_of(line.key)) found.emplace(*number, &line);
  return found;
}

}  // namespace

EdsFile EdsFile::load(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream || std::filesystem::is_directory(file))
    throw EdsError(file.string(), 0, "", "cannot be read", "an EDS file");
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  return parse(text, file.string());
}

EdsFile EdsFile::parse(std::string_view text, const std::string& name) {
  EdsFile file;
  const std::vector<EdsSection> sections = read_eds_sections(text, name);
  for (const EdsSection& section : sections)
    if (section.name == "deviceinfo")
      if (const EdsLine* const product = section.find("productname")) file.product_ = product->value;
  file.read_objects(sections, name);
  return file;
}

void EdsFile::read_objects(const std::vector<EdsSection>& sections, const std::string& name) {
  const Parser parser(name);
  std::map<std::string, const EdsSection*> by_name;
  std::set<std::uint16_t> with_subs;
  std::map<std::uint16_t, std::string> parents;
  for (const EdsSection& section : sections) {
    const auto [first, added] = by_name.emplace(section.name, &section);
    const auto object = object_of_section(section.name);
    if (!object) {
      if (is_misspelt(section))
        parser.fail(section.number, section.name, "a value without an address", "[6040], or [1018sub1] of a part");
      continue;
    }
    if (!added)
      parser.fail(section.number, section.name,
                  "the object has a section in line " + std::to_string(first->second->number) + " already",
                  "one section for each");
    if (section.name.size() > 4) with_subs.insert(object->index);
  }
  const auto lines_of = [&](const std::string& section) {
    const auto found = by_name.find(section);
    return listed(found == by_name.end() ? nullptr : found->second);
  };
  for (const EdsSection& section : sections) {
    const auto object = object_of_section(section.name);
    if (!object || section.name.size() > 4) continue;
    const std::uint32_t parts = parser.parts(section);
    const std::string own_name = parser.name(section);
    if (parts > 0) {
      const auto values = lines_of(section.name + "value");
      const ObjectEntry all = parser.entry(section);
      for (const auto& [number, line] : values) parser.check_value(section, *line, line->key, all.type);
      add_parts(all, object->index, parts, lines_of(section.name + "name"), values);
    } else if (parser.has_parts(section, with_subs.contains(object->index))) {
      parents[object->index] = own_name;
    } else {
      add(*object, "", parser.entry(section));
    }
  }
  for (const EdsSection& section : sections) {
    const auto object = object_of_section(section.name);
    if (object && section.name.size() > 4) add(*object, parents[object->index], parser.entry(section));
  }
}

void EdsFile::add(Object object, const std::string& parent, ObjectEntry entry) {
  names_.emplace(small_letters(parent.empty() ? entry.name : parent + "/" + entry.name), object);
  entries_.emplace(object, std::move(entry));
}

/// CiA 306-1: they differ at most in their names and default values.
void EdsFile::add_parts(const ObjectEntry& all, std::uint16_t index, std::uint32_t count,
                        const std::map<std::uint32_t, const EdsLine*>& names,
                        const std::map<std::uint32_t, const EdsLine*>& values) {
  add({index, 0}, all.name, {"NrOfObjects", DataType::unsigned8, "ro", std::to_string(count), "", false});
  for (std::uint32_t i = 1; i <= count; ++i) {
    ObjectEntry entry = all;
    const auto name = names.find(i);
    entry.name = name == names.end() ? all.name + std::to_string(i) : name->second->value;
    if (const auto value = values.find(i); value != values.end()) entry.default_value = value->second->value;
    add({index, static_cast<std::uint8_t>(i)}, all.name, std::move(entry));
  }
}

const ObjectEntry* EdsFile::find(Object object) const noexcept {
  const auto found = entries_.find(object);
  return found == entries_.end() ? nullptr : &found->second;
}

Object EdsFile::object(std::string_view text) const {
  const std::string wanted = small_letters(core::trimmed(text));
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
  throw std::invalid_argument(core::shown(in_quotes(text)) +
                              " is not an object of the EDS file, expected a name of it" +
                              (near.empty() ? "" : " (" + near + ")") + " or an address like 0x6040 or 0x1018:1");
}

}  // namespace mrroc::canopen
