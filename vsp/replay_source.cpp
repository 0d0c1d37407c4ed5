#include "vsp/replay_source.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>

#include "config/table.hpp"
#include "config/text/file_text.hpp"
#include "config/text/message_text.hpp"
#include "core/number_text.hpp"
#include "core/text_lines.hpp"

namespace mrroc::vsp {

namespace {

using config::ConfigurationError;
using config::in_quotes;

/// One line of the file and its position.
class Line {
 public:
  Line(const std::filesystem::path& file, int number, std::string_view text)
      : file_(&file), number_(number), text_(text), words_(core::words_of(text)) {
    if (!is_comment()) words_ = core::words_of(core::without_comment(text, '#'));
  }

  const std::vector<std::string_view>& words() const { return words_; }
  bool is_comment() const { return words_.empty() || words_[0].front() == '#'; }
  bool is_header() const {
    return words_.size() >= 3 && words_[0] == "#" && words_[1] == "mrroc" && words_[2] == "readings";
  }

  [[noreturn]] void fail(const std::string& key, const std::string& problem, const std::string& expected) const {
    throw ConfigurationError(*file_, number_, key, problem, expected);
  }

  void check_header(const std::vector<Channel>& channels) const {
    std::string header = "# mrroc readings";
    for (const Channel& channel : channels) header += " " + channel.name;
    if (!is_header()) fail("header", in_quotes(text_), in_quotes(header));
    const bool same = std::equal(words_.begin() + 3, words_.end(), channels.begin(), channels.end(),
                                 [](std::string_view word, const Channel& channel) { return word == channel.name; });
    if (!same) fail("header", "channels of another sensor: " + in_quotes(text_), in_quotes(header));
  }

  Tick tick() const {
    const std::string_view word = words_[0];
    const auto tick = core::to_whole<Tick>(word);
    if (tick && *tick != kNever) return *tick;
    const std::string why = core::to_double(word) ? "is not a tick" : core::number_problem(word);
    fail("tick", in_quotes(word) + " " + why, "a whole number of at least 0");
  }

  double value(std::size_t column, const std::string& channel) const {
    const std::string_view word = words_[column];
    const auto value = core::to_double(word);
    if (value && !std::isinf(*value)) return *value;
    const std::string why = value ? "is not finite" : core::number_problem(word);
    fail(channel, in_quotes(word) + " " + why, "a finite number or nan");
  }

 private:
  const std::filesystem::path* file_;
  int number_;
  std::string_view text_;
  std::vector<std::string_view> words_;
};

}  // namespace

ReplaySource::ReplaySource(const std::filesystem::path& file, const std::vector<Channel>& raw_channels)
    : channel_count_(raw_channels.size()) {
  const std::string content = config::read_file(file);
  try {
    read(file, core::TextLines(content), raw_channels);
  } catch (const core::TextError& error) {
    throw ConfigurationError(file, error.line, "", error.problem, error.expected);
  }
}

void ReplaySource::read(const std::filesystem::path& file, core::TextLines lines,
                        const std::vector<Channel>& channels) {
  const bool any = lines.next();
  Line{file, 1, any ? lines.line() : ""}.check_header(channels);
  while (lines.next()) {
    const Line line{file, lines.number(), lines.line()};
    if (line.is_header()) line.fail("header", "a second header", "one, in the first line");
    if (line.is_comment()) continue;
    const Tick tick = line.tick();
    if (!ticks_.empty() && tick <= ticks_.back()) {
      line.fail("tick", std::to_string(tick) + " follows " + std::to_string(ticks_.back()), "a later tick");
    }
    if (line.words().size() != channel_count_ + 1) {
      line.fail("values", std::to_string(line.words().size() - 1), std::to_string(channel_count_) + " after the tick");
    }
    ticks_.push_back(tick);
    for (std::size_t i = 0; i < channel_count_; ++i) values_.push_back(line.value(i + 1, channels[i].name));
  }
  if (ticks_.empty())
    throw ConfigurationError(file, lines.number(), "values", "no readings", "at least one line below the header");
}

SourceState ReplaySource::read(Tick wanted, RawReading& raw) noexcept {
  const auto after = std::upper_bound(ticks_.begin(), ticks_.end(), wanted);
  if (after == ticks_.begin()) return SourceState::not_ready;
  const std::size_t line = static_cast<std::size_t>(after - ticks_.begin()) - 1;
  raw.tick = wanted;  // the value holds at the wanted tick too
  raw.count = static_cast<std::uint32_t>(channel_count_);
  std::copy_n(values_.begin() + static_cast<std::ptrdiff_t>(line * channel_count_), channel_count_, raw.values.begin());
  return SourceState::ready;
}

}  // namespace mrroc::vsp
