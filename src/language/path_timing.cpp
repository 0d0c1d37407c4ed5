#include "language/path_timing.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mrroc {

namespace {

constexpr double kWindows[] = {1, 0.6, 0.36, 0.22};  // of the longest ramp: a short one suits a short path
constexpr int kRounds = 30;
constexpr double kLargestChange = 1.5;    // of the grid's stretch, in a round
constexpr double kHealedBeyond = 1.002;   // healed a little more than needed: else the rounds never end
constexpr double kExcessRounding = 1e-9;  // of the excess
constexpr double kLooksPerWindow = 8;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

}  // namespace

PathTiming::PathTiming(const RobotPath& path, double begin, double end, double sample) : PathTiming(begin, end) {
  duration_ = 0;
  if (!(end > begin)) return;
  PathGrid grid(path, begin, end);
  nodes_ = grid.nodes();
  const double longest = grid.longest_ramp();
  double best = kInfinity, window = longest;
  for (const double part : kWindows) {
    lead(grid, part * longest);
    if (unstretched_duration() >= best) continue;
    best = unstretched_duration();
    window = part * longest;
  }
  lead(grid, window);
  for (int round = 0; round < kRounds && slow_down(path, grid, sample); ++round) lead(grid, window);
  const double worst = worst_excess(path, 0.5 * sample);
  if (worst > 1 + kExcessRounding) stretch_ = worst;
  duration_ = stretch_ * unstretched_duration();
}

PathTiming PathTiming::of_time(double begin, double end) { return {begin, end}; }

void PathTiming::lead(const PathGrid& grid, double window) {
  const std::size_t cells = grid.cells();
  window_ = window;
  std::vector<double>& squares = speeds_;  // until the last loop
  squares.assign(cells + 1, kInfinity);
  squares.front() = squares.back() = 0;
  for (std::size_t i = 0; i < cells; ++i) {
    const double speed = grid.highest_speed(i, window), square = speed * speed;
    squares[i] = std::min(squares[i], square);
    squares[i + 1] = std::min(squares[i + 1], square);
  }
  for (std::size_t i = 0; i < cells; ++i) {
    const PathGrid::Bounds bounds = grid.accelerations(i, squares[i], window);
    squares[i + 1] = std::min(squares[i + 1], squares[i] + 2 * grid.width(i) * bounds.high);
  }
  for (std::size_t i = cells; i-- > 0;) {
    const PathGrid::Bounds bounds = grid.accelerations(i, squares[i + 1], window);
    squares[i] = std::min(squares[i], squares[i + 1] - 2 * grid.width(i) * bounds.low);
  }
  times_.assign(1, 0);
  integrals_.assign(1, 0);
  speeds_[0] = 0;
  for (std::size_t i = 0; i < cells; ++i) {
    speeds_[i + 1] = std::sqrt(squares[i + 1]);
    const double time = 2 * grid.width(i) / (speeds_[i] + speeds_[i + 1]);
    const double acceleration = (speeds_[i + 1] - speeds_[i]) / time;
    times_.push_back(times_[i] + time);
    integrals_.push_back(integrals_[i] +
                         time * (nodes_[i] - begin_ + time * (speeds_[i] / 2 + time * acceleration / 6)));
  }
}

bool PathTiming::slow_down(const RobotPath& path, PathGrid& grid, double sample) const {
  std::vector<double> change(nodes_.size(), 1);
  const double whole = unstretched_duration();
  const auto looks = static_cast<int>(std::ceil(whole / std::min(sample, window_ / kLooksPerWindow)));
  bool over = false;
  for (int k = 0; k <= looks; ++k) {
    const double t = whole * k / looks;
    const Point point = at(t);
    const double factor = excess_of(path, point.position, point.speed, point.acceleration, point.jerk).factor;
    if (factor <= 1 + kExcessRounding) continue;
    over = true;
    // what the window sees
    const auto from = std::lower_bound(times_.begin(), times_.end(), t - window_);
    const auto to = std::upper_bound(from, times_.end(), t);
    const auto first = static_cast<std::size_t>(std::max<std::ptrdiff_t>(from - times_.begin() - 1, 0));
    const auto last = std::min(static_cast<std::size_t>(to - times_.begin()), change.size() - 1);
    for (std::size_t i = first; i <= last; ++i)
      change[i] = std::max(change[i], std::min(kHealedBeyond * factor, kLargestChange));
  }
  for (std::size_t i = 0; i < change.size(); ++i) grid.stretch(i, change[i]);
  return over;
}

double PathTiming::worst_excess(const RobotPath& path, double sample) const {
  const double whole = unstretched_duration();
  const auto looks = static_cast<int>(std::ceil(whole / std::min(sample, window_ / (2 * kLooksPerWindow))));
  double worst = 0;
  for (int k = 0; k <= looks; ++k) {
    const Point point = at(whole * k / looks);
    worst = std::max(worst, excess_of(path, point.position, point.speed, point.acceleration, point.jerk).factor);
  }
  return worst;
}

PathTiming::Raw PathTiming::raw_at(double t) const noexcept {
  if (t <= 0) return {};
  const double length = end_ - begin_;
  if (t >= times_.back()) return {integrals_.back() + length * (t - times_.back()), length, 0, 0};
  const auto after = std::upper_bound(times_.begin() + 1, times_.end() - 1, t);
  const auto i = static_cast<std::size_t>(after - times_.begin()) - 1;
  const double acceleration = (speeds_[i + 1] - speeds_[i]) / (times_[i + 1] - times_[i]);
  const double position = nodes_[i] - begin_, speed = speeds_[i], dt = t - times_[i];
  return {integrals_[i] + dt * (position + dt * (speed / 2 + dt * acceleration / 6)),
          position + dt * (speed + dt * acceleration / 2), speed + dt * acceleration, acceleration};
}

PathTiming::Point PathTiming::at(double t) const noexcept {
  const double tau = t / stretch_;
  if (window_ == 0) return {begin_ + tau, 1 / stretch_, 0, 0};
  const Raw now = raw_at(tau), before = raw_at(tau - window_);
  return {begin_ + (now.integral - before.integral) / window_, (now.position - before.position) / (window_ * stretch_),
          (now.speed - before.speed) / (window_ * stretch_ * stretch_),
          (now.acceleration - before.acceleration) / (window_ * stretch_ * stretch_ * stretch_)};
}

}  // namespace mrroc
