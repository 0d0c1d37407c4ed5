#include "sim/scene/mjcf_part.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "config/table.hpp"
#include "core/number_text.hpp"
#include "core/text_lines.hpp"

namespace mrroc::sim {

namespace fs = std::filesystem;
using config::ConfigurationError;

namespace {

/// Attributes of MJCF that hold a name or a reference to one. Sorted.
constexpr std::array<std::string_view, 32> kNames{
    "actuator", "body",  "body1",      "body2",  "childclass", "class",   "cranksite",     "geom",
    "geom1",    "geom2", "hfield",     "joint",  "joint1",     "joint2",  "jointinparent", "material",
    "mesh",     "name",  "objname",    "prefix", "refname",    "refsite", "sidesite",      "site",
    "site1",    "site2", "slidersite", "target", "tendon",     "tendon1", "tendon2",       "texture"};
static_assert(std::is_sorted(kNames.begin(), kNames.end()));

bool holds_name(std::string_view attribute) { return std::binary_search(kNames.begin(), kNames.end(), attribute); }

constexpr double kMujocoMax = 1e10;  // beyond it MuJoCo takes a number for a divergence

void check_numbers(const Element& element) {
  for (const auto& [key, value] : element.attributes) {
    if (holds_name(key) || key.starts_with("file") || key == "data") continue;
    std::string blanks = value;
    std::replace_if(
        blanks.begin(), blanks.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
    for (const std::string_view word : core::words_of(blanks)) {
      const auto number = core::to_double(word);
      const bool comma = !number && core::number_problem(word) == "has a decimal comma";
      if (!comma && (number ? std::abs(*number) <= kMujocoMax : !core::is_too_large(word))) continue;
      throw ConfigurationError(*element.origin.file, element.origin.line, element.name + "." + key,
                               std::string(word) + (comma ? " has a decimal comma" : " is not finite or too large"),
                               "numbers up to 1e10");
    }
  }
  for (const Element& child : element.children) check_numbers(child);
}

class Transformer {
 public:
  Transformer(const fs::path& file, std::string prefix) : folder_(file.parent_path()), prefix_(std::move(prefix)) {}

  std::string renamed(const std::string& attribute, const std::string& name) const {
    const bool is_class = attribute == "class" || attribute == "childclass";
    return is_class && name == "main" ? main_class() : prefix_ + name;
  }
  std::string main_class() const { return prefix_.empty() ? "/main" : prefix_ + "main"; }

  void rename(Element& element) const {
    for (auto& [key, value] : element.attributes) {
      if (holds_name(key) && !value.empty()) value = renamed(key, value);
    }
    for (Element& child : element.children) rename(child);
  }

  /// Takes the folders out of `compiler`: they hold for this part only.
  void take_folders(Element& compiler) {
    if (const auto* folder = compiler.find("meshdir")) mesh_folder_ = folder_ / *folder;
    if (const auto* folder = compiler.find("texturedir")) texture_folder_ = folder_ / *folder;
    strip_ = compiler.value_or("strippath", "false") == "true";
    for (const char* key : {"meshdir", "texturedir", "strippath"}) compiler.remove(key);
  }

  /// Makes the files of an asset absolute; a nameless asset is named after its file, as MuJoCo does, but before the
  /// prefix.
  void locate(Element& asset) const {
    const fs::path& folder = asset.name == "texture" ? texture_folder_ : mesh_folder_;
    for (auto& [key, value] : asset.attributes) {
      if (!key.starts_with("file")) continue;
      const fs::path named = strip_ ? fs::path(value).filename() : fs::path(value);
      value = fs::absolute((folder.empty() ? folder_ : folder) / named).lexically_normal().string();
    }
    if (const auto* file = asset.find("file"); file != nullptr && asset.find("name") == nullptr) {
      asset.set("name", fs::path(*file).stem().string());
    }
  }

 private:
  fs::path folder_;
  std::string prefix_;
  fs::path mesh_folder_, texture_folder_;
  bool strip_ = false;
};

/// Whether a section's direct children take a default class.
bool takes_class(const std::string& section, const std::string& element) {
  if (section == "asset") return element == "mesh" || element == "material";
  if (section == "contact") return element == "pair";
  return section == "equality" || section == "tendon" || section == "actuator";
}

void append(Element& to, Element&& from) {
  for (auto& [key, value] : from.attributes) to.set(key, std::move(value));
  std::move(from.children.begin(), from.children.end(), std::back_inserter(to.children));
}

}  // namespace

MjcfPart read_part(const fs::path& file, const std::string& prefix) {
  Element root = load_mjcf(file);
  check_numbers(root);
  Transformer transformer(file, prefix);
  MjcfPart part;
  part.origin = root.origin;
  part.main_class = transformer.main_class();
  part.compiler = {"compiler", {}, {}, root.origin};
  part.defaults = {"default", {}, {}, root.origin};
  for (Element& section : root.children) {
    if (section.name == "compiler") {
      part.compiler.origin = section.origin;
      append(part.compiler, std::move(section));
    } else if (section.name == "default") {
      transformer.rename(section);
      append(part.defaults, std::move(section));
    } else if (section.name == "worldbody") {
      if (!section.attributes.empty()) {
        throw ConfigurationError(*section.origin.file, section.origin.line, "worldbody",
                                 "has attribute \"" + section.attributes.front().first + "\"", "none");
      }
      transformer.rename(section);
      std::move(section.children.begin(), section.children.end(), std::back_inserter(part.world));
    } else if (section.name != "keyframe") {
      part.sections.push_back(std::move(section));
    }
  }
  part.defaults.set("class", part.main_class);
  transformer.take_folders(part.compiler);
  for (Element& section : part.sections) {
    for (Element& child : section.children) {
      if (section.name == "asset") transformer.locate(child);
      transformer.rename(child);
      if (takes_class(section.name, child.name) && child.find("class") == nullptr) child.set("class", part.main_class);
    }
  }
  return part;
}

}  // namespace mrroc::sim
