#include "sim/scene/xml.hpp"

#include <tinyxml2.h>

#include <algorithm>
#include <set>

#include "config/table.hpp"
#include "config/text/file_text.hpp"
#include "config/text/xml_file.hpp"

namespace mrroc::sim {

namespace fs = std::filesystem;
using config::ConfigurationError;

const std::string* Element::find(std::string_view attribute) const {
  for (const auto& [key, value] : attributes) {
    if (key == attribute) return &value;
  }
  return nullptr;
}

std::string Element::value_or(std::string_view attribute, std::string_view fallback) const {
  const auto* value = find(attribute);
  return value != nullptr ? *value : std::string(fallback);
}

void Element::set(std::string_view attribute, std::string value) {
  for (auto& [key, present] : attributes) {
    if (key == attribute) {
      present = std::move(value);
      return;
    }
  }
  attributes.emplace_back(attribute, std::move(value));
}

void Element::remove(std::string_view attribute) {
  std::erase_if(attributes, [&](const auto& pair) { return pair.first == attribute; });
}

namespace {

class Reader {
 public:
  explicit Reader(const fs::path& file) : directory_(file.parent_path()) { included_.insert(file); }

  /// The root element of `file`; `from` is the include that names it.
  Element read(const fs::path& file, const Origin& from) {
    tinyxml2::XMLDocument document;
    if (from.file && !config::reading_problem(file).empty())
      throw ConfigurationError(*from.file, from.line, "include", "cannot read \"" + file.string() + "\"",
                               "an MJCF file");
    config::read_xml(file, "an MJCF file", document);
    const auto* root = document.RootElement();
    if (root == nullptr) throw ConfigurationError(file, 1, "", "no XML element", "<mujoco>");
    return convert(*root, std::make_shared<const fs::path>(file));
  }

 private:
  Element convert(const tinyxml2::XMLElement& xml, const std::shared_ptr<const fs::path>& file) {
    Element element{.name = xml.Name(), .attributes = {}, .children = {}, .origin = {file, xml.GetLineNum()}};
    for (const auto* a = xml.FirstAttribute(); a != nullptr; a = a->Next()) {
      element.attributes.emplace_back(a->Name(), a->Value());
    }
    for (const auto* child = xml.FirstChildElement(); child != nullptr; child = child->NextSiblingElement()) {
      auto converted = convert(*child, file);
      if (converted.name == "include") {
        auto included = include(converted);
        std::move(included.begin(), included.end(), std::back_inserter(element.children));
      } else {
        element.children.push_back(std::move(converted));
      }
    }
    return element;
  }

  std::vector<Element> include(const Element& element) {
    const auto* name = element.find("file");
    if (name == nullptr) {
      throw ConfigurationError(*element.origin.file, element.origin.line, "include", "no attribute \"file\"",
                               "file=\"...\"");
    }
    const fs::path file = directory_ / *name;
    if (!included_.insert(file).second) {
      throw ConfigurationError(*element.origin.file, element.origin.line, "include",
                               "\"" + *name + "\" is included a second time", "each file once");
    }
    return read(file, element.origin).children;
  }

  fs::path directory_;
  std::set<fs::path> included_;
};

std::string escaped(const std::string& value) {
  std::string result;
  for (const char c : value) {
    switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '"':
        result += "&quot;";
        break;
      case '\n':
        result += ' ';
        break;  // one element, one line
      default:
        result += c;
    }
  }
  return result;
}

void write_element(const Element& element, const std::string& indent, Text& out) {
  out.text += indent + "<" + element.name;
  for (const auto& [key, value] : element.attributes) out.text += " " + key + "=\"" + escaped(value) + "\"";
  out.text += element.children.empty() ? "/>\n" : ">\n";
  out.lines.push_back(element.origin);
  if (element.children.empty()) return;
  for (const auto& child : element.children) write_element(child, indent + " ", out);
  out.text += indent + "</" + element.name + ">\n";
  out.lines.push_back(element.origin);
}

}  // namespace

Element load_mjcf(const fs::path& file) {
  Element root = Reader(file).read(file, {});
  if (root.name != "mujoco") {
    throw ConfigurationError(file, root.origin.line, "", "the root element is <" + root.name + ">", "<mujoco>");
  }
  return root;
}

Text write(const Element& root) {
  Text out;
  write_element(root, "", out);
  return out;
}

}  // namespace mrroc::sim
