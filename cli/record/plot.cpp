#include "cli/record/plot.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <vector>

namespace mrroc::cli::record {

namespace {

// in pixels
constexpr double kWidth = 1000, kPanel = 220, kLeft = 80, kRight = 20, kTop = 26, kBottom = 30;
constexpr double kColumns = kWidth - kLeft - kRight;
constexpr int kTicksAcross = 10, kTicksUp = 5;

// distinct for people who see colours differently, too (Okabe and Ito)
constexpr char kColours[][8] = {"#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#000000", "#999999"};

struct Range {
  double least = 0, greatest = 1;
};

template <class Values>
void widen(Range& range, const Values& values, bool& first) {
  for (const double value : values) {
    range.least = first ? value : std::min(range.least, value);
    range.greatest = first ? value : std::max(range.greatest, value);
    first = false;
  }
}

constexpr double kGreatest = 1e300;   // that is drawn: the width of a range stays finite
constexpr double kFinest = 1e-9;      // width of a range, as a part of its values
constexpr double kSmallest = 1e-300;  // the same as a number

/// With room above and below; never empty, nor so narrow that its round numbers would not differ.
Range padded(const Range& range) {
  const double least = std::max(range.least, -kGreatest), greatest = std::min(range.greatest, kGreatest);
  const double size = std::max(std::abs(least), std::abs(greatest));
  const double room =
      greatest > least ? std::max({0.05 * (greatest - least), kFinest * size, kSmallest}) : std::max(1e-3, 0.1 * size);
  return {least - room, greatest + room};
}

/// The distance of about `count` round numbers in the range: 1, 2 or 5 times a power of ten.
double tick_step(const Range& range, int count) {
  const double raw = (range.greatest - range.least) / count;
  const double power = std::pow(10, std::floor(std::log10(raw)));
  for (const double factor : {1.0, 2.0, 5.0})
    if (factor * power >= raw) return factor * power;
  return 10 * power;
}

/// The round numbers in a range, in order.
std::vector<double> ticks_of(const Range& range, int count) {
  const double step = tick_step(range, count);
  std::vector<double> ticks;
  for (double i = std::ceil(range.least / step); i * step <= range.greatest; ++i) ticks.push_back(i * step);
  return ticks;
}

std::string escaped(const std::string& text) {
  std::string result;
  for (const char character : text) {
    if (character == '&')
      result += "&amp;";
    else if (character == '<')
      result += "&lt;";
    else
      result += character;
  }
  return result;
}

/// One panel: where its values are in the picture.
class Panel {
 public:
  Panel(const Range& time, const Range& value, double top) : time_(time), value_(value), top_(top) {}

  double x(double time) const { return kLeft + kColumns * (time - time_.least) / (time_.greatest - time_.least); }
  double y(double value) const {
    return top_ + kTop +
           height() * (value_.greatest - std::clamp(value, value_.least, value_.greatest)) /
               (value_.greatest - value_.least);
  }

  std::string axes() const {
    std::string svg;
    for (const double tick : ticks_of(time_, kTicksAcross))
      svg += fmt::format(
          "<path class=\"grid\" d=\"M{0:.1f} {1:.1f}V{2:.1f}\"/><text class=\"time\" x=\"{0:.1f}\" "
          "y=\"{3:.1f}\">{4:.6g}</text>\n",
          x(tick), top_ + kTop, bottom(), bottom() + 14, tick);
    for (const double tick : ticks_of(value_, kTicksUp))
      svg += fmt::format(
          "<path class=\"grid\" d=\"M{0:.1f} {1:.1f}H{2:.1f}\"/><text class=\"value\" x=\"{3:.1f}\" "
          "y=\"{4:.1f}\">{5:.6g}</text>\n",
          kLeft, y(tick), kWidth - kRight, kLeft - 6, y(tick) + 4, tick);
    return svg;
  }

  /// The points in order, or the extremes of each column of pixels.
  std::string line(const Signal& signal, const char* colour) const {
    std::string path;
    const auto add = [&](double time, double value) {
      path += fmt::format("{}{:.1f} {:.1f}", path.empty() ? "M" : "L", x(time), y(value));
    };
    const std::size_t count = signal.times.size();
    if (static_cast<double>(count) <= 2 * kColumns) {
      for (std::size_t i = 0; i < count; ++i) add(signal.times[i], signal.values[i]);
    } else {
      for (std::size_t begin = 0, end = 0; begin < count; begin = end) {
        std::size_t least = begin, greatest = begin;
        const double column = std::floor(x(signal.times[begin]));
        for (end = begin; end < count && std::floor(x(signal.times[end])) == column; ++end) {
          if (signal.values[end] < signal.values[least]) least = end;
          if (signal.values[end] > signal.values[greatest]) greatest = end;
        }
        for (const std::size_t i : {std::min(least, greatest), std::max(least, greatest)})
          add(signal.times[i], signal.values[i]);
      }
    }
    return fmt::format("<path class=\"line\" stroke=\"{}\" d=\"{}\"/>\n", colour, path);
  }

  std::string names(const std::vector<Signal>& signals) const {
    std::string svg = fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\">", kLeft, top_ + kTop - 8);
    for (std::size_t i = 0; i < signals.size(); ++i)
      svg += fmt::format("<tspan fill=\"{}\">{}{}</tspan>", kColours[i % std::size(kColours)], i == 0 ? "" : "   ",
                         escaped(signals[i].name));
    return svg + "</text>\n";
  }

 private:
  static constexpr double height() { return kPanel - kTop - kBottom; }
  double bottom() const { return top_ + kTop + height(); }

  Range time_, value_;
  double top_;
};

}  // namespace

std::string draw(const std::vector<std::vector<Signal>>& groups) {
  Range time;
  bool first = true;
  for (const std::vector<Signal>& group : groups)
    for (const Signal& signal : group) widen(time, signal.times, first);
  if (time.greatest <= time.least) time.greatest = time.least + 1;

  const double height = kPanel * static_cast<double>(groups.size()) + 20;
  std::string svg = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" height=\"{1}\">\n"
      "<style>text {{ font: 12px sans-serif; white-space: pre }} .time {{ text-anchor: middle; fill: #555 }} "
      ".value {{ text-anchor: end; fill: #555 }} .grid {{ stroke: #ddd; fill: none }} "
      ".line {{ fill: none; stroke-width: 1.2; stroke-linejoin: round }}</style>\n"
      "<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n",
      kWidth, height);
  for (std::size_t i = 0; i < groups.size(); ++i) {
    Range value;
    first = true;
    for (const Signal& signal : groups[i]) widen(value, signal.values, first);
    const Panel panel(time, padded(value), kPanel * static_cast<double>(i));
    svg += panel.axes() + panel.names(groups[i]);
    for (std::size_t line = 0; line < groups[i].size(); ++line)
      svg += panel.line(groups[i][line], kColours[line % std::size(kColours)]);
  }
  return svg + fmt::format("<text class=\"time\" x=\"{:.1f}\" y=\"{:.1f}\">time of the run, s</text>\n</svg>\n",
                           kLeft + kColumns / 2, height - 8);
}

}  // namespace mrroc::cli::record
