#include "language/paths/path_runner.hpp"

#include <algorithm>
#include <cmath>

#include "language/joints/joint_targets.hpp"
#include "mrroc/task.hpp"

namespace mrroc {

namespace {

constexpr double kTimeRounding = 1e-9;  // s: sums of step durations are not exact
constexpr double kSame = 1e-9;          // s at full speed: no distance
constexpr double kReturnSpeed = 0.5;    // back to the path, of the robot's limits
constexpr double kFarthest = 2;  // the nearest point is searched up to this multiple of the deviation along the path
constexpr double kSoon = 2;      // s: a robot closer to its stop than its braking distance rests there
constexpr int kLooks = 64;       // of the search for it, in each direction
constexpr int kHalvings = 40;
constexpr double kDifference = 1e-4;                          // s
constexpr int kPaceLooks = 256;                               // of a motion
constexpr double kPaceReserve = 1.5;                          // for the motion between two of them
constexpr double kFewestTimeLooks = 8, kMostTimeLooks = 400;  // checks of a piece of a path with times
constexpr int kMostRests = 6;                                 // halvings of a path by rests in it

}  // namespace

double PathRunner::whole_steps(double duration) const noexcept {
  return std::ceil(duration / robot_->step_duration() - kTimeRounding) * robot_->step_duration();
}

void PathRunner::lead_to(const JointVector& joints, double speed) {
  lead_.emplace(*robot_, joints, speed);
  lead_->start();
  leading_ = !lead_->terminal_condition();
  if (leading_) duration_ += whole_steps(lead_->duration());
}

JointVector PathRunner::begin() {
  const RobotState& state = robot_->known_state();
  path_.reset();
  timings_.clear();
  next_ = 0;
  leading_ = false;
  brake_.reset();
  halting_ = false;
  duration_ = 0;
  if (state.at_rest()) return state.desired_joints;
  JointVector rest = resting_joints(*robot_);
  lead_to(rest, 1);
  return rest;
}

void PathRunner::follow(std::unique_ptr<RobotPath> path) {
  path_ = std::move(path);
  if (path_->is_timed()) {
    check_times();
    timings_.push_back(PathTiming::of_time(0, path_->length()));
    check_limits(timings_.back());
    time_ = place_ = 0;
    duration_ += whole_steps(path_->length());
    return;
  }
  plan_from(0);
}

void PathRunner::check_times() const {
  const double period = robot_->task().servo_period();
  const std::vector<double>& breaks = path_->breaks();
  Excess worst;
  double when = 0;
  for (std::size_t piece = 0; piece + 1 < breaks.size(); ++piece) {
    const double from = breaks[piece], time = breaks[piece + 1] - from;
    const auto looks = static_cast<int>(std::clamp(std::ceil(time / period), kFewestTimeLooks, kMostTimeLooks));
    for (int k = 0; k <= looks; ++k) {
      const double t = from + time * k / looks;
      const Excess excess = excess_of(*path_, t, 1, 0, 0);
      if (excess.factor <= worst.factor) continue;
      worst = excess;
      when = t;
    }
  }
  if (worst.factor <= 1) return;
  const auto axis = static_cast<std::size_t>(path_->limits()[worst.limit].row - kJointRow);
  throw NonFatalError(worst.code,
                      "joint " + robot_->parameters().axes[axis].name + " would be too fast at " +
                          std::to_string(when) + " s, expected times that are " + std::to_string(worst.factor) +
                          " times as long",
                      {robot_->task().process_name(), robot_->name(), 0, robot_->state().tick});
}

/// Stretches the motion if the EDP would refuse it; one with times by less than a macrostep.
void PathRunner::check_limits(PathTiming& timing) {
  if (!check_) check_.emplace(*robot_);
  const MotionCheck::States states = [this, &timing](double time) { return state(timing, time); };
  double when = 0;
  const MotionPace pace = pace_of(timing);
  if (!bad(check_->check(states, timing.duration(), when, pace))) return;
  const double shortest = timing.duration();
  for (const double slower : kSlower) {
    timing.stretch_to(whole_steps(slower * shortest));
    if (path_->is_timed() || !bad(check_->check(states, timing.duration(), when, pace))) break;
  }
  check_->require(states, timing.duration(), pace);
}

MotionPace PathRunner::pace_of(const PathTiming& timing) const {
  double fastest = 0;
  for (int k = 0; k < kPaceLooks; ++k) {
    const DesiredState now = state(timing, timing.duration() * k / kPaceLooks);
    for (std::size_t i = 0; i < robot_->parameters().axes.size(); ++i) {
      const AxisParameters& axis = robot_->parameters().axes[i];
      const auto row = static_cast<Eigen::Index>(i);
      fastest = std::max({fastest, std::abs(now.velocity[row]) / axis.velocity_max,
                          std::sqrt(std::abs(now.acceleration[row]) / axis.acceleration_max)});
    }
  }
  return {0, std::min(1.0, kPaceReserve * fastest)};
}

DesiredState PathRunner::state(const PathTiming& timing, double time) const {
  if (time >= timing.duration() - kTimeRounding) return DesiredState::resting_at(path_->joints(timing.end()));
  // the EDP takes the joints' rates from the tool's motion: as exact as these, unlike those interpolated for the timing
  const auto joints_at = [&](double t) {
    return path_->joints(timing.at(std::clamp(t, 0.0, timing.duration())).position);
  };
  const JointVector before = joints_at(time - kDifference), joints = joints_at(time),
                    after = joints_at(time + kDifference);
  return {joints, (after - before) / (2 * kDifference), (after - 2 * joints + before) / (kDifference * kDifference)};
}

void PathRunner::plan_from(double s) {
  timings_.clear();
  next_ = 0;
  time_ = 0;
  place_ = s;
  for (const double stop : path_->stops()) {
    if (stop <= place_ + kSame) {
      place_ = std::max(place_, stop);
      continue;
    }
    add(PathTiming(*path_, place_, stop, robot_->step_duration()), kMostRests);
    place_ = stop;
  }
  place_ = s;
}

void PathRunner::add(PathTiming timing, int more_rests) {
  if (const std::optional<double> rest = more_rests > 0 ? timing.slow_place() : std::nullopt) {
    PathTiming before(*path_, timing.begin(), *rest, robot_->step_duration());
    PathTiming after(*path_, *rest, timing.end(), robot_->step_duration());
    if (whole_steps(before.duration()) + whole_steps(after.duration()) < whole_steps(timing.duration())) {
      add(std::move(before), more_rests - 1);
      add(std::move(after), more_rests - 1);
      return;
    }
  }
  check_limits(timing);
  duration_ += whole_steps(timing.duration());
  timings_.push_back(std::move(timing));
}

bool PathRunner::brake() noexcept {
  if (leading_ || over()) return false;
  const PathTiming& timing = timings_[next_];
  brake_ = PathBrake::find(*path_, timing.at(time_), timing.end(), robot_->step_duration());
  braked_ = 0;
  halting_ = !brake_ && timing.duration() - time_ < kSoon;
  return brake_ || halting_;
}

void PathRunner::resume() {
  if (!path_) return;
  brake_.reset();
  halting_ = false;
  duration_ = 0;
  leading_ = false;
  const bool on_path = path_->length() == 0 || distance(place_) <= kSame;
  const double s = on_path ? place_ : nearest_point();
  if (distance(s) > kSame) lead_to(path_->joints(s), kReturnSpeed);
  plan_from(s);
}

double PathRunner::distance(double s) const {
  const JointVector way = path_->joints(s) - robot_->state().desired_joints;
  double square = 0;
  for (std::size_t i = 0; i < robot_->parameters().axes.size(); ++i) {
    const double time = way[static_cast<Eigen::Index>(i)] / robot_->parameters().axes[i].velocity_max;
    square += time * time;
  }
  return std::sqrt(square);
}

double PathRunner::nearest_point() const {
  const auto next = [](const std::vector<double>& places, double s) {
    const auto after = std::upper_bound(places.begin(), places.end(), s);
    return after == places.end() ? places.back() : *after;
  };
  const auto stop = std::upper_bound(path_->stops().begin(), path_->stops().end(), place_);
  const double last = stop == path_->stops().begin() ? 0 : *(stop - 1);
  const double here = distance(place_);
  double best = place_, least = here, width = 0;
  for (const double end : {next(path_->waypoints(), place_), last}) {
    const double ds = (end - place_) / kLooks;
    double way = 0;  // along the path: a path that passes nearby again later is not cut short
    JointVector before = path_->joints(place_);
    for (int k = 1; k <= kLooks && way <= kFarthest * here; ++k) {
      const double s = k < kLooks ? place_ + k * ds : end;
      const JointVector now = path_->joints(s);
      double square = 0;
      for (Eigen::Index i = 0; i < now.size(); ++i)
        square +=
            std::pow((now[i] - before[i]) / robot_->parameters().axes[static_cast<std::size_t>(i)].velocity_max, 2);
      way += std::sqrt(square);
      before = now;
      if (distance(s) < least) {
        least = distance(s);
        best = s;
      }
      width = std::max(width, std::abs(ds));
    }
  }
  double low = std::max(best - width, last), high = std::min(best + width, next(path_->waypoints(), place_));
  for (int k = 0; k < kHalvings; ++k) {
    const double third = (high - low) / 3;
    if (distance(low + third) < distance(high - third)) {
      high -= third;
    } else {
      low += third;
    }
  }
  return 0.5 * (low + high);
}

void PathRunner::step() {
  if (leading_) {
    lead_->next_state();
    leading_ = !lead_->terminal_condition();
    return;
  }
  if (brake_) return step_of_brake();
  const PathTiming& timing = timings_[next_];
  time_ += robot_->step_duration();
  if (time_ < timing.duration() - kTimeRounding) {
    const PathTiming::Point point = timing.at(time_);
    place_ = point.position;
    path_->command(place_, point.speed, point.acceleration, robot_->command());
    return;
  }
  place_ = timing.end();
  path_->command(place_, 0, 0, robot_->command());
  if (halting_) return;
  ++next_;
  time_ = 0;
}

void PathRunner::step_of_brake() noexcept {
  braked_ += robot_->step_duration();
  const PathTiming::Point point = brake_->at(braked_);
  place_ = point.position;
  path_->command(place_, point.speed, point.acceleration, robot_->command());
}

}  // namespace mrroc
