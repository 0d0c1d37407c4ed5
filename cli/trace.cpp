#include "cli/trace.hpp"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <fstream>
#include <stdexcept>

namespace mrroc::cli {

namespace {

struct Line {
  std::uint64_t tick = 0;
  std::string text;
};

const char* name_of(config::ClockMode clock) noexcept {
  switch (clock) {
    case config::ClockMode::real:
      return "real";
    case config::ClockMode::paced:
      return "paced";
    case config::ClockMode::lockstep:
      return "lockstep";
  }
  return "real";
}

/// A line without a tick belongs to the line before, as does one with an older tick.
std::uint64_t tick_of(const std::string& text, std::uint64_t before) {
  constexpr std::string_view key = "tick=";
  std::uint64_t tick = before;
  if (text.starts_with(key)) std::from_chars(text.data() + key.size(), text.data() + text.size(), tick);
  return std::max(tick, before);
}

}  // namespace

void create_trace(const std::filesystem::path& trace) {
  if (!std::ofstream(trace))
    throw std::runtime_error("cannot write the trace " + trace.string() + ": " + std::strerror(errno));
}

void merge_traces(const std::vector<std::filesystem::path>& parts, const std::filesystem::path& merged,
                  config::ClockMode clock) {
  std::vector<std::filesystem::path> sorted = parts;
  std::sort(sorted.begin(), sorted.end());
  std::vector<Line> lines;
  for (const std::filesystem::path& part : sorted) {
    std::ifstream file(part);
    if (!file) throw std::runtime_error("cannot read the trace " + part.string());
    std::uint64_t tick = 0;
    for (std::string text; std::getline(file, text);) {
      if (file.eof()) break;  // no end of line: its process was killed while it wrote
      lines.push_back({tick = tick_of(text, tick), text});
    }
  }
  std::stable_sort(lines.begin(), lines.end(), [](const Line& a, const Line& b) { return a.tick < b.tick; });
  std::ofstream file(merged);
  file << kTraceHeader << name_of(clock) << '\n';
  for (const Line& line : lines) file << line.text << '\n';
  if (!file.flush()) throw std::runtime_error("cannot write the trace " + merged.string());
}

std::string hash_trace(const std::filesystem::path& trace) {
  std::ifstream file(trace, std::ios::binary);
  if (!file) throw std::runtime_error("cannot read the trace " + trace.string());
  std::uint64_t hash = 0xcbf29ce484222325U;
  std::string text;
  if (!std::getline(file, text) || !text.starts_with(kTraceHeader)) {
    throw std::runtime_error(trace.string() + ":1: is no trace, expected the line \"" + std::string{kTraceHeader} +
                             "...\"");
  }
  while (std::getline(file, text)) {
    text += '\n';
    for (const char character : text) {
      hash ^= static_cast<unsigned char>(character);
      hash *= 0x100000001b3U;
    }
  }
  const char* const digits = "0123456789abcdef";
  std::string result(16, '0');
  for (std::size_t i = 0; i < 16; ++i) result[15 - i] = digits[(hash >> (4 * i)) & 15U];
  return result;
}

}  // namespace mrroc::cli
