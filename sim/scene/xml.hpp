#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace mrroc::sim {

/// Position of an element: file and line (from 1; 0: added by the framework).
struct Origin {
  std::shared_ptr<const std::filesystem::path> file;
  int line = 0;
};

/// One XML element with its attributes in file order. MJCF has no text between elements; comments are dropped.
struct Element {
  std::string name;
  std::vector<std::pair<std::string, std::string>> attributes;
  std::vector<Element> children;
  Origin origin;

  const std::string* find(std::string_view attribute) const;
  std::string value_or(std::string_view attribute, std::string_view fallback) const;
  /// Sets the attribute, or adds it after the others.
  void set(std::string_view attribute, std::string value);
  void remove(std::string_view attribute);
};

/// Reads an MJCF file; every `<include file="..."/>` is replaced by the included root's children (paths relative to
/// `file`, each file once, as in MuJoCo). Throws config::ConfigurationError with file and line: unreadable, not well
/// formed, root not `<mujoco>`, included twice.
Element load_mjcf(const std::filesystem::path& file);

/// XML text with the origin of each of its lines.
struct Text {
  std::string text;
  std::vector<Origin> lines;  ///< lines[i] belongs to line i + 1
};

/// Writes one element per line, so that a line number in an error message names one element.
Text write(const Element& root);

}  // namespace mrroc::sim
