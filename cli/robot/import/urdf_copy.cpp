#include "cli/robot/import/urdf_copy.hpp"

#include <tinyxml2.h>

#include "config/text/file_text.hpp"

namespace mrroc::cli {

namespace {

/// The value of an attribute as XML reads it.
std::string unescaped(const std::string& quoted) {
  tinyxml2::XMLDocument document;
  if (document.Parse(("<a b=" + quoted + "/>").c_str()) != tinyxml2::XML_SUCCESS) return "";
  return document.RootElement()->Attribute("b");
}

}  // namespace

std::string urdf_copy(const std::filesystem::path& urdf, const std::map<std::string, std::string>& files) {
  constexpr std::string_view kAttribute = "filename";
  const std::string text = config::read_file(urdf);
  std::string copy;
  std::size_t done = 0;
  for (std::size_t at = text.find(kAttribute); at != std::string::npos; at = text.find(kAttribute, at + 1)) {
    const std::size_t begin = text.find_first_of("\"'", at);
    const std::size_t equals = text.find_first_not_of(" \t\r\n", at + kAttribute.size());
    if (begin == std::string::npos || equals == std::string::npos || text[equals] != '=') continue;
    const std::size_t end = text.find(text[begin], begin + 1);
    if (end == std::string::npos) break;
    const auto file = files.find(unescaped(text.substr(begin, end - begin + 1)));
    if (file == files.end()) continue;
    copy += text.substr(done, begin - done) + "\"meshes/" + file->second + ".stl\"";
    done = end + 1;
  }
  return copy + text.substr(done);
}

}  // namespace mrroc::cli
