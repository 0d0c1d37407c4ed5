#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "sim/scene/xml.hpp"

namespace mrroc::sim {

/// One MJCF file prepared to share a world with others: names prefixed, files absolute, defaults in its own class.
struct MjcfPart {
  Origin origin;                  ///< of the root element
  Element compiler;               ///< all its `compiler` sections in one, without folders
  std::string main_class;         ///< "<prefix>main", "/main" for the empty prefix
  Element defaults;               ///< its main default class, renamed
  std::vector<Element> sections;  ///< all others, in file order, but worldbody and keyframe
  std::vector<Element> world;     ///< children of its worldbody
};

/// Reads `file` and puts `prefix` before every name and reference. Elements that take a default class and name none
/// get the part's main class. Throws config::ConfigurationError as `compose`.
MjcfPart read_part(const std::filesystem::path& file, const std::string& prefix);

}  // namespace mrroc::sim
