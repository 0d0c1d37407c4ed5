#include "cli/robot/import/findings.hpp"

#include <algorithm>

namespace mrroc::cli {

namespace {

constexpr std::size_t kNamedSubjects = 8;

}  // namespace

void Findings::add(Kind kind, const std::string& text, const std::string& subject, int line) {
  auto found = std::find_if(findings_.begin(), findings_.end(),
                            [&](const Finding& each) { return each.kind == kind && each.text == text; });
  if (found == findings_.end()) found = findings_.insert(found, {kind, text, {}});
  found->subjects.push_back({subject, line});
}

std::string Findings::text() const {
  std::string text;
  for (const Kind kind : {Kind::warning, Kind::guess}) {
    for (const Finding& finding : findings_) {
      if (finding.kind != kind) continue;
      text += (kind == Kind::guess ? "guessed: " : "warning: ") + file_.filename().string();
      if (finding.subjects.front().line > 0) text += ":" + std::to_string(finding.subjects.front().line);
      text += ": ";
      for (std::size_t i = 0; i < std::min(finding.subjects.size(), kNamedSubjects); ++i)
        text += (i > 0 ? ", " : "") + finding.subjects[i].name;
      if (finding.subjects.size() > kNamedSubjects)
        text += " and " + std::to_string(finding.subjects.size() - kNamedSubjects) + " more";
      text += ": " + finding.text + "\n";
    }
  }
  return text;
}

}  // namespace mrroc::cli
