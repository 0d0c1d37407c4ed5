#include "cli/can/can_monitor.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <stdexcept>

#include "cli/can/can_summary.hpp"
#include "clock/wall/monotonic.hpp"

namespace mrroc::cli {

namespace {

constexpr std::int64_t kGlance = clock::kSecond / 20;  // between two checks of `stop`
constexpr double kLongest = 1e9;                       // s: the longest time that the clock can count

double seconds_of(std::int64_t time) { return static_cast<double>(time) / 1e9; }

}  // namespace

void monitor(can::Bus& bus, CanFrameFormatter& words, const MonitorOptions& options, const std::function<bool()>& stop,
             const std::function<void(std::string_view text)>& show) {
  const std::int64_t begin = clock::monotonic_ns();
  const std::int64_t end = begin + static_cast<std::int64_t>(std::min(options.seconds, kLongest) * 1e9);
  std::int64_t first = 0;
  CanSummary summary;
  bool gone = false;
  std::uint64_t count = 0;
  for (std::int64_t now = begin; !stop() && !gone && count < options.count && now < end; now = clock::monotonic_ns()) {
    const std::int64_t until = std::min(end, now + kGlance);
    can::Frame frame;
    if (!bus.receive(frame, until)) {
      gone = clock::monotonic_ns() < until;
      continue;
    }
    now = clock::monotonic_ns();
    if (count++ == 0) first = now;
    const std::string line = words.line(frame);
    if (options.summary)
      summary.add(frame);
    else
      show(fmt::format("{:12.6f}  {}\n", seconds_of(now - first), line));
  }
  if (options.summary) show(summary.text(words, seconds_of(clock::monotonic_ns() - begin), options.bit_rate));
  if (gone) throw std::runtime_error("the bus is gone: its hub has ended");
}

}  // namespace mrroc::cli
