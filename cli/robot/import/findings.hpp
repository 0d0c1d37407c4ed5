#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace mrroc::cli {

/// What an import had to guess, and what looks wrong in the file. One thread.
class Findings {
 public:
  enum class Kind { guess, warning };

  explicit Findings(std::filesystem::path file) : file_(std::move(file)) {}

  /// `subject` (a joint, a link, an element) in line `line` of the file, 0: none. Findings of the same text share a
  /// line of the report.
  void add(Kind kind, const std::string& text, const std::string& subject, int line);
  void guess(const std::string& text, const std::string& subject, int line) { add(Kind::guess, text, subject, line); }
  void warn(const std::string& text, const std::string& subject, int line) { add(Kind::warning, text, subject, line); }

  /// Lines "warning: FILE:12: SUBJECT, SUBJECT: TEXT" and "guessed: ...", the line number that of the first subject, in
  /// the order in which they were added, warnings first. Of many subjects the first ones are named.
  std::string text() const;

 private:
  struct Subject {
    std::string name;
    int line;
  };
  struct Finding {
    Kind kind;
    std::string text;
    std::vector<Subject> subjects;
  };
  std::filesystem::path file_;
  std::vector<Finding> findings_;
};

}  // namespace mrroc::cli
