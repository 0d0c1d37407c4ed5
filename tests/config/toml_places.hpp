#pragma once

#include <charconv>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace mrroc::config {

/// Locations of the keys of a plain TOML file (one `key = value` or one header a line), read without the code under
/// test.
class TomlPlaces {
 public:
  struct Entry {
    int line;             ///< from 1
    std::string section;  ///< full key of its table
    std::string key;
    std::string value;
  };

  explicit TomlPlaces(const std::string& text) {
    std::istringstream stream(text);
    std::string section, content;
    std::map<std::string, int> elements;  // of each array of tables
    for (int line = 1; std::getline(stream, content); ++line) {
      if (content.starts_with("[[")) {
        const std::string name = content.substr(2, content.find(']') - 2);
        section = name + "[" + std::to_string(elements[name]++) + "]";
        add(name, line);
        add(section, line);
      } else if (content.starts_with("[")) {
        section = content.substr(1, content.find(']') - 1);
        for (auto dot = section.find('.'); dot != std::string::npos; dot = section.find('.', dot + 1)) {
          add(section.substr(0, dot), line);
        }
        add(section, line);
      } else if (const auto equal = content.find(" = "); equal != std::string::npos) {
        entries_.push_back({line, section, content.substr(0, equal), content.substr(equal + 3)});
        add(section + "." + entries_.back().key, line);
      }
    }
  }

  const std::vector<Entry>& entries() const { return entries_; }

  bool has(const std::string& full_key) const { return lines_.contains(full_key); }

  /// The line for an error at `full_key`: its own line; for an array's element that of the array; for a missing key
  /// that of the nearest table above.
  int line(std::string full_key) const {
    while (!lines_.contains(full_key)) {
      const auto cut = full_key.find_last_of(".[");
      if (cut == std::string::npos) return 1;
      full_key.resize(cut);
    }
    return lines_.at(full_key);
  }

 private:
  void add(const std::string& full_key, int line) { lines_.emplace(full_key, line); }

  std::vector<Entry> entries_;
  std::map<std::string, int> lines_;
};

/// Parts of a message `<file>:<line>: <key>: <problem>`, with a file name without a colon. Line 0: the message has
/// another form.
struct Complaint {
  int line = 0;
  std::string key;
  std::string problem;

  explicit Complaint(const std::string& message) {
    const auto number = message.find(':') + 1;
    const auto key_begin = message.find(": ") + 2;
    const auto key_end = message.find(": ", key_begin);
    if (number == 0 || number >= key_begin) return;
    const auto [end, error] = std::from_chars(message.data() + number, message.data() + message.size(), line);
    if (error != std::errc() || end != message.data() + key_begin - 2) line = 0;
    if (key_end == std::string::npos) return;  // of the text, not of a key
    key = message.substr(key_begin, key_end - key_begin);
    problem = message.substr(key_end + 2);
  }
};

}  // namespace mrroc::config
