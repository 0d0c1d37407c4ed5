#include "geometry/natural_spline.hpp"

#include <algorithm>

namespace mrroc {

NaturalSpline::NaturalSpline(std::vector<double> times, std::vector<JointVector> positions)
    : times_(std::move(times)), positions_(std::move(positions)) {
  const std::size_t n = times_.size();
  const JointVector zero = JointVector::Zero(positions_.front().size());
  curvatures_.assign(n, zero);
  // h_i-1 m_i-1 + 2 (h_i-1 + h_i) m_i + h_i m_i+1 = 6 (slope_i - slope_i-1): tridiagonal, solved by elimination
  std::vector<double> upper(n, 0);
  for (std::size_t i = 1; i + 1 < n; ++i) {
    const double left = times_[i] - times_[i - 1], right = times_[i + 1] - times_[i];
    const JointVector change = (positions_[i + 1] - positions_[i]) / right - (positions_[i] - positions_[i - 1]) / left;
    const double pivot = 2 * (left + right) - left * upper[i - 1];
    upper[i] = right / pivot;
    curvatures_[i] = (6 * change - left * curvatures_[i - 1]) / pivot;
  }
  for (std::size_t i = n - 1; i-- > 1;) curvatures_[i] -= upper[i] * curvatures_[i + 1];
}

NaturalSpline::Sample NaturalSpline::at(double time) const noexcept {
  const auto after = std::upper_bound(times_.begin() + 1, times_.end() - 1, time);
  const auto i = static_cast<std::size_t>(after - times_.begin());
  const double h = times_[i] - times_[i - 1], t = time - times_[i - 1];
  const JointVector& m0 = curvatures_[i - 1];
  Sample sample;
  sample.third = (curvatures_[i] - m0) / h;
  const JointVector slope = (positions_[i] - positions_[i - 1]) / h - (h / 6) * (2 * m0 + curvatures_[i]);
  sample.position = positions_[i - 1] + t * (slope + t * (0.5 * m0 + (t / 6) * sample.third));
  sample.first = slope + t * (m0 + (0.5 * t) * sample.third);
  sample.second = m0 + t * sample.third;
  return sample;
}

}  // namespace mrroc
