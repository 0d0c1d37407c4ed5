#include "language/paths/robot_path.hpp"

#include <algorithm>
#include <cmath>

namespace mrroc {

std::size_t RobotPath::piece_at(double s) const noexcept {
  if (breaks_.size() < 2) return 0;
  const auto after = std::upper_bound(breaks_.begin() + 1, breaks_.end() - 1, s);
  return static_cast<std::size_t>(after - breaks_.begin()) - 1;
}

Excess excess_of(const RobotPath& path, double s, double speed, double acceleration, double jerk) noexcept {
  const PathRates rates = path.rates(path.piece_at(s), s);
  const PathRow v = speed * rates.first;
  const PathRow a = acceleration * rates.first + speed * speed * rates.second;
  const PathRow j = jerk * rates.first + 3 * speed * acceleration * rates.second + speed * speed * speed * rates.third;
  Excess worst;
  const auto judge = [&worst](double factor, std::size_t limit, ErrorCode code) {
    if (factor > worst.factor) worst = {factor, limit, code};
  };
  for (std::size_t i = 0; i < path.limits().size(); ++i) {
    const PathLimit& limit = path.limits()[i];
    judge(v.segment(limit.row, limit.rows).norm() / limit.velocity, i, ErrorCode::velocity_limit);
    judge(std::sqrt(a.segment(limit.row, limit.rows).norm() / limit.acceleration), i, ErrorCode::acceleration_limit);
    judge(std::cbrt(j.segment(limit.row, limit.rows).norm() / limit.jerk), i, ErrorCode::jerk_limit);
  }
  return worst;
}

}  // namespace mrroc
