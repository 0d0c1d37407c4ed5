#include "calibration/postures.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <string>

#include "calibration/view_postures.hpp"
#include "core/require.hpp"

namespace mrroc::calibration {

namespace {

constexpr int kSteps = 2;  // of the grid, to each side of a joint
constexpr int kJoints = 3;

/// The centre is not checked for limits: the robot is there.
std::vector<JointVector> candidates_of(const RobotModel& model, const PostureRegion& region) {
  const auto moved = std::min<Eigen::Index>(kJoints, region.centre.size());
  std::vector<JointVector> candidates{region.centre};
  for (Eigen::Index i = region.centre.size() - moved; i < region.centre.size(); ++i) {
    const std::size_t before = candidates.size();
    for (std::size_t k = 0; k < before; ++k) {
      for (int step = -kSteps; step <= kSteps; ++step) {
        if (step == 0) continue;
        candidates.push_back(candidates[k]);
        candidates.back()[i] += region.reach * step / kSteps;
      }
    }
  }
  candidates.erase(std::remove_if(candidates.begin() + 1, candidates.end(),
                                  [&](const JointVector& joints) { return !within_limits(model, joints); }),
                   candidates.end());
  return candidates;
}

/// Sums over the directions of gravity that were taken.
struct Directions {
  Eigen::Matrix3d products = Eigen::Matrix3d::Zero();
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  double count = 0;

  void add(const Eigen::Vector3d& u) {
    products += u * u.transpose();
    sum += u;
    count += 1;
  }
  /// The smallest eigenvalue with u added.
  double weakest_with(const Eigen::Vector3d& u) const {
    Directions with = *this;
    with.add(u);
    const Eigen::Matrix3d scatter = with.products - with.sum * with.sum.transpose() / with.count;
    const Eigen::Matrix3d normal = scatter.trace() * Eigen::Matrix3d::Identity() - scatter;
    return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(normal, Eigen::EigenvaluesOnly).eigenvalues()[0];
  }
};

}  // namespace

std::vector<JointVector> gravity_postures(const RobotModel& model, const PostureRegion& region, std::size_t count) {
  require(region.centre.size() == model.joint_count(), "gravity_postures", "joints of the centre",
          static_cast<double>(region.centre.size()), "those of the robot");
  require_above_zero("gravity_postures", "reach", region.reach);
  std::vector<JointVector> candidates = candidates_of(model, region);
  if (candidates.size() < count)
    throw NonFatalError(ErrorCode::invalid_argument, std::to_string(candidates.size()) +
                                                         " postures are within the limits around the present one, "
                                                         "expected at least " +
                                                         std::to_string(count) +
                                                         ": move the robot away from its limits");
  std::vector<JointVector> postures;
  Directions taken;
  while (postures.size() < count) {
    std::size_t best = 0;
    double largest = -1;
    for (std::size_t k = 0; k < candidates.size() && !postures.empty(); ++k) {
      const Eigen::Vector3d down = -model.flange(candidates[k]).linear().row(2).transpose();
      const double weakest = taken.weakest_with(down);
      if (weakest > largest + 1e-9) {
        largest = weakest;
        best = k;
      }
    }
    postures.push_back(candidates[best]);
    taken.add(-model.flange(candidates[best]).linear().row(2).transpose());
    candidates.erase(candidates.begin() + static_cast<std::ptrdiff_t>(best));
  }
  return postures;
}

}  // namespace mrroc::calibration
