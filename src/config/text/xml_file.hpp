#pragma once

#include <filesystem>
#include <string>

namespace tinyxml2 {
class XMLDocument;
}

namespace mrroc::config {

/// Reads an XML file (URDF, MJCF) into `document`; `kind` names the expected document, as "a URDF". Throws
/// ConfigurationError with file and line: unreadable, not well formed, a declaration `<?xml ...?>` that is not first,
/// and everything that core/text_lines.hpp refuses except long lines. Configuration time.
void read_xml(const std::filesystem::path& file, const std::string& kind, tinyxml2::XMLDocument& document);

}  // namespace mrroc::config
