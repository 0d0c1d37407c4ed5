#include "language/paths/path_timing.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mrroc {

namespace {

constexpr double kWindows[] = {1, 0.6, 0.36, 0.22};  // of the longest ramp: a short one suits a short path
constexpr int kRounds = 30;
constexpr double kLargestChange = 1.5;    // of the grid's stretch, in a round
constexpr double kHealedBeyond = 1.002;   // corrected a little more than needed: otherwise the rounds never end
constexpr double kExcessRounding = 1e-9;  // of the excess
constexpr double kLooksPerWindow = 8;
constexpr int kMostLooks = 4000;     // at equal distances
constexpr int kSamplesPerPiece = 8;  // at least
constexpr int kLooksPerCell = 6;     // of the grid, on long motions
constexpr int kTimeHalvings = 60;
constexpr double kDip = 0.1;        // of the speeds before and after: slower is almost a rest
constexpr double kUnhealed = 1.05;  // a stretch of the whole path required by one point
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
  double worst = 0;
  for_samples(path, 0.5 * sample, 2 * kLooksPerWindow, [&](double t) {
    const Point point = at(t);
    const double factor = excess_of(path, point.position, point.speed, point.acceleration, point.jerk).factor;
    if (factor <= worst) return;
    worst = factor;
    worst_place_ = point.position;
  });
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
  bool over = false;
  for_samples(path, sample, kLooksPerWindow, [&](double t) {
    const Point point = at(t);
    const double factor = excess_of(path, point.position, point.speed, point.acceleration, point.jerk).factor;
    if (factor <= 1 + kExcessRounding) return;
    over = true;
    // the part inside the window
    const auto from = std::lower_bound(times_.begin(), times_.end(), t - window_);
    const auto to = std::upper_bound(from, times_.end(), t);
    const auto first = static_cast<std::size_t>(std::max<std::ptrdiff_t>(from - times_.begin() - 1, 0));
    const auto last = std::min(static_cast<std::size_t>(to - times_.begin()), change.size() - 1);
    for (std::size_t i = first; i <= last; ++i)
      change[i] = std::max(change[i], std::min(kHealedBeyond * factor, kLargestChange));
  });
  for (std::size_t i = 0; i < change.size(); ++i) grid.stretch(i, change[i]);
  return over;
}

template <class Visit>
void PathTiming::for_samples(const RobotPath& path, double sample, double per_window, Visit visit) const {
  const double whole = unstretched_duration(), looks = std::ceil(whole / std::min(sample, window_ / per_window));
  if (looks > kMostLooks * per_window / kLooksPerWindow) {
    for (std::size_t i = 0; i + 1 < times_.size(); ++i) {
      const double part = (times_[i + 1] - times_[i]) / kLooksPerCell;
      for (int k = 0; k < kLooksPerCell; ++k) {
        const double t = times_[i] + k * part;
        visit(t), visit(t + 0.5 * window_), visit(t + window_);
      }
    }
    visit(whole);
    return;
  }
  const int count = static_cast<int>(looks);
  for (int k = 0; k <= count; ++k) visit(whole * k / count);
  const double spacing = whole / count;
  for (std::size_t piece = 0; piece + 1 < path.breaks().size(); ++piece) {
    const double low = std::max(begin_, path.breaks()[piece]), high = std::min(end_, path.breaks()[piece + 1]);
    if (!(high > low)) continue;
    const auto first = std::lower_bound(nodes_.begin(), nodes_.end(), low) - nodes_.begin();
    const auto last = std::lower_bound(nodes_.begin(), nodes_.end(), high) - nodes_.begin();
    const double raw = times_[static_cast<std::size_t>(last)] - times_[static_cast<std::size_t>(first)];
    if (raw > kSamplesPerPiece * spacing && raw > window_) continue;
    const double from = time_of(low), time = time_of(high) - from;
    if (time > kSamplesPerPiece * spacing) continue;
    for (int k = 0; k <= kSamplesPerPiece; ++k) visit(from + time * k / kSamplesPerPiece);
  }
}

double PathTiming::time_of(double s) const noexcept {
  double low = 0, high = unstretched_duration();
  for (int k = 0; k < kTimeHalvings && low < high; ++k) {
    const double t = 0.5 * (low + high);
    const double place = begin_ + (raw_at(t).integral - raw_at(t - window_).integral) / window_;
    (place < s ? low : high) = t;
  }
  return 0.5 * (low + high);
}

std::optional<double> PathTiming::slow_place() const noexcept {
  if (stretch_ > kUnhealed && worst_place_ > begin_ && worst_place_ < end_) return worst_place_;
  std::optional<double> found;
  double before = 0, least = kDip;
  for (std::size_t i = 1; i + 1 < nodes_.size(); ++i) {
    before = std::max(before, speeds_[i - 1]);
    if (speeds_[i] >= least * before) continue;
    const double after = *std::max_element(speeds_.begin() + static_cast<std::ptrdiff_t>(i), speeds_.end());
    if (speeds_[i] >= least * std::min(before, after)) continue;
    least = speeds_[i] / std::min(before, after);
    found = nodes_[i];
  }
  return found;
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
