#include "cli/output/trace.hpp"

#include <algorithm>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "config/clock_names.hpp"
#include "core/number_text.hpp"
#include "mrroc/fnv.hpp"

namespace mrroc::cli {

namespace {

/// Removes what an editor or a file transfer has added around a line of a trace, so that the hash stays the same.
void take_off_extras(std::string& text, bool first) {
  if (first && text.starts_with("\xEF\xBB\xBF")) text.erase(0, 3);
  while (text.ends_with('\r')) text.pop_back();
}

/// A line without a tick belongs to the line before, as does one with an older tick.
std::uint64_t tick_of(std::string_view text, std::uint64_t before) {
  constexpr std::string_view key = "tick=";
  std::uint64_t tick = before;
  if (text.starts_with(key)) std::from_chars(text.data() + key.size(), text.data() + text.size(), tick);
  return std::max(tick, before);
}

/// A part of a trace, read line by line: a trace of hours is larger than memory.
class Part {
 public:
  explicit Part(const std::filesystem::path& path) : file_(path) {
    if (!file_) throw std::runtime_error("cannot read the trace " + path.string());
    next();
  }
  bool ended() const noexcept { return ended_; }
  std::uint64_t tick() const noexcept { return tick_; }
  const std::string& text() const noexcept { return text_; }
  void next() {
    // a last line without an end: its process was killed while it wrote
    ended_ = !std::getline(file_, text_) || file_.eof();
    if (!ended_) tick_ = tick_of(text_, tick_);
  }

 private:
  std::ifstream file_;
  std::string text_;
  std::uint64_t tick_ = 0;  // the newest so far
  bool ended_ = false;
};

}  // namespace

void merge_traces(const std::vector<std::filesystem::path>& parts, config::ClockMode clock,
                  const std::function<void(std::string_view text)>& write) {
  constexpr std::size_t kPiece = 65536;
  std::vector<std::filesystem::path> sorted = parts;
  std::sort(sorted.begin(), sorted.end());
  std::vector<Part> open(sorted.begin(), sorted.end());
  std::string text = std::string{kTraceHeader} + config::name_of(clock) + "\n";
  const auto earlier = [](const Part& a, const Part& b) { return !a.ended() && (b.ended() || a.tick() < b.tick()); };
  for (auto first = open.begin(); !open.empty(); first->next()) {
    first = std::min_element(open.begin(), open.end(), earlier);  // the first of those that are equally early
    if (first->ended()) break;
    text.append(first->text()).push_back('\n');
    if (text.size() < kPiece) continue;
    write(text);
    text.clear();
  }
  write(text);
}

std::string merge_lines(const std::map<std::string, std::vector<std::string_view>>& processes) {
  std::vector<std::pair<std::uint64_t, std::string_view>> lines;  // with the newest tick of their process so far
  for (const auto& [process, own] : processes) {
    std::uint64_t newest = 0;
    for (const std::string_view line : own) lines.emplace_back(newest = tick_of(line, newest), line);
  }
  std::stable_sort(lines.begin(), lines.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::string text;
  for (const auto& [tick, line] : lines) text.append(line).push_back('\n');
  return text;
}

namespace {

std::string hash_stream(const std::filesystem::path& trace, std::istream& file) {
  std::string text;
  const bool any = static_cast<bool>(std::getline(file, text));
  take_off_extras(text, true);
  if (!any || !text.starts_with(kTraceHeader)) {
    throw std::runtime_error(trace.string() + ":1: is not a trace, expected the line \"" + std::string{kTraceHeader} +
                             "...\"");
  }
  Fnv1a hash;
  while (std::getline(file, text)) {
    take_off_extras(text, false);
    hash.add(text).add("\n");
  }
  return core::hexadecimal(hash.value());
}

}  // namespace

std::string hash_trace(const std::filesystem::path& trace) {
  std::ifstream file(trace, std::ios::binary);
  if (!file) throw std::runtime_error("cannot read the trace " + trace.string());
  return hash_stream(trace, file);
}

std::string hash_trace(const std::filesystem::path& name, const std::string& text) {
  std::istringstream stream(text);
  return hash_stream(name, stream);
}

}  // namespace mrroc::cli
