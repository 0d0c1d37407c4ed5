#include "calibration/short_tour.hpp"

#include <algorithm>

namespace mrroc::calibration {

namespace {

constexpr double kWorthwhile = 1e-9;  // s: less may come from rounding

/// The time between postures, without accelerations.
class TravelTime {
 public:
  explicit TravelTime(const RobotModel& model) : slowness_(model.joint_count()) {
    for (Eigen::Index i = 0; i < slowness_.size(); ++i)
      slowness_[i] = 1 / model.parameters().axes[static_cast<std::size_t>(i)].velocity_max;
  }
  double operator()(const JointVector& from, const JointVector& to) const {
    return (to - from).cwiseProduct(slowness_).cwiseAbs().maxCoeff();
  }

 private:
  JointVector slowness_;
};

void order_by_nearest(std::vector<JointVector>& tour, const TravelTime& time) {
  for (std::size_t k = 1; k + 1 < tour.size(); ++k) {
    const auto next = std::min_element(
        tour.begin() + static_cast<std::ptrdiff_t>(k), tour.end(),
        [&](const JointVector& a, const JointVector& b) { return time(tour[k - 1], a) < time(tour[k - 1], b); });
    std::iter_swap(tour.begin() + static_cast<std::ptrdiff_t>(k), next);
  }
}

/// Reverses the part from `first` to `last` if that shortens the tour, which may end anywhere.
bool reverse_part(std::vector<JointVector>& tour, std::size_t first, std::size_t last, const TravelTime& time) {
  double gain = time(tour[first - 1], tour[first]) - time(tour[first - 1], tour[last]);
  if (last + 1 < tour.size()) gain += time(tour[last], tour[last + 1]) - time(tour[first], tour[last + 1]);
  if (gain < kWorthwhile) return false;
  std::reverse(tour.begin() + static_cast<std::ptrdiff_t>(first), tour.begin() + static_cast<std::ptrdiff_t>(last) + 1);
  return true;
}

}  // namespace

std::vector<JointVector> short_tour(const RobotModel& model, const JointVector& start,
                                    std::vector<JointVector> postures) {
  const TravelTime time(model);
  postures.insert(postures.begin(), start);
  order_by_nearest(postures, time);
  for (bool shorter = true; shorter;) {
    shorter = false;
    for (std::size_t first = 1; first + 1 < postures.size(); ++first)
      for (std::size_t last = first + 1; last < postures.size(); ++last)
        shorter = reverse_part(postures, first, last, time) || shorter;
  }
  postures.erase(postures.begin());
  return postures;
}

}  // namespace mrroc::calibration
