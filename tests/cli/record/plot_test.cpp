// The picture of signals: each has its line, which passes through its points, and no peak is lost in many of them.
#include "cli/record/plot.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <regex>
#include <string>
#include <utility>
#include <vector>

namespace mrroc::cli::record::plot_test {
namespace {

using Points = std::vector<std::pair<double, double>>;

/// The lines of a picture, in pixels.
std::vector<Points> lines_of(const std::string& svg) {
  static const std::regex point("[ML]([-0-9.]+) ([-0-9.]+)");
  const std::string line = "<path class=\"line\"", data = " d=\"";
  std::vector<Points> lines;
  // by hand: std::regex needs stack for each character of a path
  for (std::size_t found = svg.find(line); found != std::string::npos; found = svg.find(line, found + 1)) {
    const std::size_t begin = svg.find(data, found) + data.size();
    const std::string path = svg.substr(begin, svg.find('"', begin) - begin);
    lines.emplace_back();
    for (std::sregex_iterator each(path.begin(), path.end(), point), none; each != none; ++each)
      lines.back().emplace_back(std::stod((*each)[1]), std::stod((*each)[2]));
  }
  return lines;
}

Signal signal_of(const std::string& name, std::size_t count, double (*value)(std::size_t)) {
  Signal signal{name, {}, {}};
  for (std::size_t i = 0; i < count; ++i) {
    signal.times.push_back(static_cast<double>(i) * 0.002);
    signal.values.push_back(value(i));
  }
  return signal;
}

TEST(Plot, LinesPassThroughTheirPoints) {
  const std::string svg = draw({{signal_of("/a/x", 5, [](std::size_t i) { return static_cast<double>(i % 2); })},
                                {signal_of("/b/y", 5, [](std::size_t i) { return 10.0 - static_cast<double>(i); }),
                                 signal_of("/b/z", 5, [](std::size_t) { return 8.0; })}});
  const std::vector<Points> lines = lines_of(svg);
  ASSERT_EQ(lines.size(), 3U);
  for (const Points& points : lines) ASSERT_EQ(points.size(), 5U);
  // a common axis of time; up is greater
  for (std::size_t i = 0; i < 5; ++i) EXPECT_EQ(lines[0][i].first, lines[1][i].first);
  EXPECT_GT(lines[0][0].second, lines[0][1].second);
  EXPECT_EQ(lines[0][0].second, lines[0][2].second);
  for (std::size_t i = 1; i < 5; ++i) EXPECT_GT(lines[1][i].second, lines[1][i - 1].second);
  // a common axis of values within a panel
  EXPECT_NEAR(lines[1][2].second, lines[2][2].second, 0.11);
  // the second panel is below the first
  for (const auto& [x, y] : lines[0]) EXPECT_LT(y, lines[1][0].second);
  for (const char* name : {"/a/x", "/b/y", "/b/z"}) EXPECT_NE(svg.find(name), std::string::npos);
}

TEST(Plot, KeepsAPeakOfOneTickAmongManyPoints) {
  constexpr std::size_t kCount = 200'000, kPeak = 123'456;
  const auto value = [](std::size_t i) { return i == kPeak ? 100.0 : 0.0; };
  const std::vector<Points> lines = lines_of(draw({{signal_of("/a/x", kCount, value)}}));
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_LT(lines[0].size(), 2000U);
  const double first = lines[0].front().first, last = lines[0].back().first;
  const auto peak = std::min_element(lines[0].begin(), lines[0].end(),
                                     [](const auto& one, const auto& other) { return one.second < other.second; });
  EXPECT_LT(peak->second, lines[0].front().second - 100);
  EXPECT_NEAR(peak->first, first + (last - first) * kPeak / (kCount - 1.0), 1.5);
}

TEST(Plot, DrawsSignalsThatDoNotChangeAndSinglePoints) {
  for (const std::size_t count : {std::size_t{1}, std::size_t{3}}) {
    for (const double constant : {0.0, -7.0, 1e-12, 1e12}) {
      Signal signal = signal_of("/a/x", count, [](std::size_t) { return 0.0; });
      signal.values.assign(count, constant);
      const std::string svg = draw({{signal}});
      EXPECT_EQ(svg.find("nan"), std::string::npos);
      EXPECT_EQ(svg.find("inf"), std::string::npos);
      EXPECT_LT(svg.size(), 10'000U);
      ASSERT_EQ(lines_of(svg).size(), 1U);
      EXPECT_EQ(lines_of(svg)[0].size(), count);
    }
  }
}

TEST(Plot, DrawsValuesThatHardlyDifferAndHugeOnes) {
  const std::pair<double, double> ranges[] = {{1e16, 1e16 + 2}, {1, 1 + 1e-15},   {-1e308, 1e308},
                                              {0, 5e-324},      {1e-300, 2e-300}, {-1e16 - 2, -1e16}};
  for (const auto& [least, greatest] : ranges) {
    Signal signal = signal_of("/a/x", 2, [](std::size_t) { return 0.0; });
    signal.values = {least, greatest};
    const std::string svg = draw({{signal}});
    EXPECT_EQ(svg.find("nan"), std::string::npos) << least;
    EXPECT_EQ(svg.find("inf"), std::string::npos) << least;
    EXPECT_LT(svg.size(), 10'000U) << least;
    EXPECT_EQ(lines_of(svg).at(0).size(), 2U) << least;
  }
}

TEST(Plot, EscapesNames) {
  const std::string svg = draw({{signal_of("/a<b>&c", 2, [](std::size_t i) { return static_cast<double>(i); })}});
  EXPECT_NE(svg.find("/a&lt;b>&amp;c"), std::string::npos);
}

}  // namespace
}  // namespace mrroc::cli::record::plot_test
