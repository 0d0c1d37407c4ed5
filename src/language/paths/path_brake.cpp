#include "language/paths/path_brake.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mrroc {

namespace {

constexpr double kGentler = 0.8;         // each try
constexpr int kTries = 24;               // down to a 200th
constexpr double kBrakeBeyond = 1.002;   // of the limits, as PathTiming
constexpr double kBeyondEnd = 1e-9;      // of s
constexpr double kBrakeRounding = 1e-9;  // s

/// The maximum acceleration and jerk of s alone that the limits allow at a point.
struct Reserve {
  double acceleration = std::numeric_limits<double>::infinity();
  double jerk = std::numeric_limits<double>::infinity();
};

Reserve reserve_at(const RobotPath& path, double s) noexcept {
  const PathRates rates = path.rates(path.piece_at(s), s);
  Reserve reserve{path.pace().acceleration, std::numeric_limits<double>::infinity()};
  for (const PathLimit& limit : path.limits()) {
    const double way = rates.first.segment(limit.row, limit.rows).norm();
    if (way == 0) continue;
    reserve.acceleration = std::min(reserve.acceleration, limit.acceleration / way);
    reserve.jerk = std::min(reserve.jerk, limit.jerk / way);
  }
  return reserve;
}

}  // namespace

std::optional<PathBrake> PathBrake::find(const RobotPath& path, const PathTiming::Point& now, double end,
                                         double sample) noexcept {
  const Reserve reserve = reserve_at(path, now.position);
  ruckig::InputParameter<1> input;
  input.control_interface = ruckig::ControlInterface::Velocity;
  input.current_position[0] = now.position;
  input.current_velocity[0] = now.speed;
  input.current_acceleration[0] = now.acceleration;
  double share = 1;
  for (int k = 0; k < kTries; ++k, share *= kGentler) {
    input.max_acceleration[0] = share * reserve.acceleration;
    input.max_jerk[0] = share * reserve.jerk;
    PathBrake brake;
    ruckig::Ruckig<1> ruckig;
    const ruckig::Result result = ruckig.calculate(input, brake.motion_);
    if (result != ruckig::Result::Working && result != ruckig::Result::Finished) continue;
    if (brake.at(brake.duration()).position > end + kBeyondEnd) return std::nullopt;  // a gentler one overshoots more
    if (brake.keeps_limits(path, sample)) return brake;
  }
  return std::nullopt;
}

PathTiming::Point PathBrake::at(double t) const noexcept {
  PathTiming::Point point;
  motion_.at_time(std::min(t, duration()), point.position, point.speed, point.acceleration);
  if (t >= duration() - kBrakeRounding) point.speed = point.acceleration = 0;
  return point;
}

bool PathBrake::keeps_limits(const RobotPath& path, double sample) const noexcept {
  PathTiming::Point before = at(0);
  const auto looks = static_cast<int>(std::ceil(duration() / sample));
  for (int k = 1; k <= looks; ++k) {
    const PathTiming::Point now = at(k * sample);
    const double jerk = (now.acceleration - before.acceleration) / sample;
    if (excess_of(path, now.position, now.speed, now.acceleration, jerk).factor > kBrakeBeyond) return false;
    before = now;
  }
  return true;
}

}  // namespace mrroc
