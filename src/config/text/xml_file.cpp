#include "config/text/xml_file.hpp"

#include <tinyxml2.h>

#include <algorithm>
#include <limits>
#include <string_view>

#include "config/table.hpp"
#include "config/text/file_text.hpp"
#include "core/text_lines.hpp"

namespace mrroc::config {

namespace {

/// The encoding, and bytes 0, at which tinyxml2 would end.
void check_text(const std::filesystem::path& file, std::string_view text) {
  try {
    constexpr std::size_t kAnyLength = std::numeric_limits<std::size_t>::max();
    for (int line = 1; !text.empty(); ++line) {
      const std::size_t size = std::min(text.find('\n'), text.size());
      const std::string_view raw = text.substr(0, size);
      // a CR alone is a line end of XML
      if (line == 1 || raw.find('\0') != std::string_view::npos)
        core::content_of_line(raw.substr(0, raw.find('\r')), line, kAnyLength);
      text.remove_prefix(std::min(size + 1, text.size()));
    }
  } catch (const core::TextError& error) {
    throw ConfigurationError(file, error.line, "", error.problem, error.expected);
  }
}

/// The line of a declaration that is not first; 0: no such line. Comments do not count.
int late_declaration(std::string_view text) {
  constexpr std::string_view kDeclaration = "<?xml ", kComment = "<!--", kCommentEnd = "-->";
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  for (std::size_t place = 1; place < text.size(); ++place) {
    const std::string_view rest = text.substr(place - 1);
    if (rest.starts_with(kComment)) {
      const std::size_t end = rest.find(kCommentEnd);
      if (end == std::string_view::npos) return 0;
      place += end + kCommentEnd.size() - 1;
    } else if (place > 1 && rest.starts_with(kDeclaration)) {
      return 1 + static_cast<int>(std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(place), '\n'));
    }
  }
  return 0;
}

std::string problem_of(tinyxml2::XMLError error) {
  switch (error) {
    case tinyxml2::XML_ERROR_PARSING_ELEMENT:
      return "an element's tag is not well-formed or not closed";
    case tinyxml2::XML_ERROR_PARSING_ATTRIBUTE:
      return "an attribute is not of the form name=\"value\"";
    case tinyxml2::XML_ERROR_PARSING_TEXT:
      return "text that is in no element";
    case tinyxml2::XML_ERROR_PARSING_CDATA:
      return "a CDATA section has no end";
    case tinyxml2::XML_ERROR_PARSING_COMMENT:
      return "a comment has no end";
    case tinyxml2::XML_ERROR_PARSING_DECLARATION:
      return "the declaration <?xml ...?> has no end";
    case tinyxml2::XML_ERROR_PARSING_UNKNOWN:
      return "a part <!...> has no end";
    case tinyxml2::XML_ERROR_EMPTY_DOCUMENT:
      return "the file has no element";
    case tinyxml2::XML_ERROR_MISMATCHED_ELEMENT:
      return "the end tag of an element is missing or has another name";
    case tinyxml2::XML_ELEMENT_DEPTH_EXCEEDED:
      return "elements are nested too deeply";
    default:
      return tinyxml2::XMLDocument::ErrorIDToName(error);
  }
}

}  // namespace

void read_xml(const std::filesystem::path& file, const std::string& kind, tinyxml2::XMLDocument& document) {
  if (const std::string problem = reading_problem(file); !problem.empty())
    throw ConfigurationError(file, 0, "", problem, kind);
  const std::string content = read_file(file);
  const std::string_view text = core::without_dos_end(content);
  check_text(file, text);
  if (document.Parse(text.data(), text.size()) == tinyxml2::XML_SUCCESS) {
    const tinyxml2::XMLElement* const root = document.RootElement();
    if (const auto* second = root != nullptr ? root->NextSiblingElement() : nullptr)
      throw ConfigurationError(file, second->GetLineNum(), "", "a second element outside of the first", "one element");
    return;
  }
  const int declaration = late_declaration(text);
  if (document.ErrorID() == tinyxml2::XML_ERROR_PARSING_DECLARATION && declaration > 0)
    throw ConfigurationError(file, declaration, "", "the declaration <?xml ...?> is not at the beginning of the file",
                             "it before everything else, comments too");
  throw ConfigurationError(file, document.ErrorLineNum(), "", problem_of(document.ErrorID()), "well-formed XML");
}

}  // namespace mrroc::config
