#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "system/equal_runs.hpp"
#include "system/trace_steps_of.hpp"

namespace mrroc::test::draw_test {
namespace {

using Place = std::array<double, 3>;

/// A stroke from the trace: commanded and measured positions of the tool, m.
struct Stroke {
  std::string generator;
  std::vector<Place> commanded, measured;
};

Place place_of(const std::vector<double>& pose) { return {pose.at(0), pose.at(1), pose.at(2)}; }

double distance(const Place& a, const Place& b) { return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]); }

/// Distance of a position from a chain of positions.
double beside(const Place& place, const std::vector<Place>& chain) {
  double least = 1e9;
  for (std::size_t i = 0; i + 1 < chain.size(); ++i) {
    const Place &from = chain[i], &to = chain[i + 1];
    double gone = 0, length = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      gone += (place[k] - from[k]) * (to[k] - from[k]);
      length += (to[k] - from[k]) * (to[k] - from[k]);
    }
    const double u = length > 0 ? std::clamp(gone / length, 0.0, 1.0) : 0;
    Place there{};
    for (std::size_t k = 0; k < 3; ++k) there[k] = from[k] + u * (to[k] - from[k]);
    least = std::min(least, distance(place, there));
  }
  return least;
}

/// All motions whose commands are poses.
std::vector<Stroke> strokes_of(const std::filesystem::path& trace) {
  std::vector<Stroke> strokes;
  std::uint64_t last = 0;
  for (const cli::trace::Line& step : steps_of(trace)) {
    if (!step.is_move || step.robots.empty()) continue;
    const cli::trace::RobotEntry& robot = step.robots.front();
    if (!robot.command || robot.command->kind != CommandKind::pose) continue;
    if (step.instruction != last) strokes.push_back({step.name, {}, {}});
    last = step.instruction;
    strokes.back().commanded.push_back(place_of(robot.command->target));
    strokes.back().measured.push_back(place_of(robot.pose));
  }
  return strokes;
}

TEST(Draw, EveryStrokeIsOnItsPathInEveryRun) {
  const ScratchFolder folder;
  const auto trace = expect_equal_runs("tasks/draw/draw.toml", folder).trace;

  std::map<std::string, int> drawn;
  for (const Stroke& stroke : strokes_of(trace)) {
    ++drawn[stroke.generator];
    double worst = 0, longest = 0;
    for (std::size_t i = 2; i < stroke.measured.size(); ++i)
      worst = std::max(worst, beside(stroke.measured[i], stroke.commanded));
    for (std::size_t i = 1; i < stroke.commanded.size(); ++i)
      longest = std::max(longest, distance(stroke.commanded[i], stroke.commanded[i - 1]));
    std::printf("%s: %zu steps, up to %.1f mm/s, at most %.2f mm beside its path\n", stroke.generator.c_str(),
                stroke.commanded.size(), 1000 * longest / 0.02, 1000 * worst);
    EXPECT_LT(worst, 1e-3) << stroke.generator;
    EXPECT_LT(longest / 0.02, 0.0801) << stroke.generator;
  }
  const std::map<std::string, int> expected{
      {"BlendedPath", 1}, {"CartesianArc", 2}, {"CartesianLine", 1}, {"PoseSpline", 2}};
  EXPECT_EQ(drawn, expected);
}

}  // namespace
}  // namespace mrroc::test::draw_test
