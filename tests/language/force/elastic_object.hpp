#pragma once

#include <memory>
#include <vector>

#include "language/cooperation/free_team.hpp"
#include "language/cooperation/internal_wrench.hpp"
#include "language/random_values.hpp"
#include "mrroc/generators/cooperative_motion.hpp"
#include "mrroc/move.hpp"

namespace mrroc::fakes {

inline constexpr double kStiffness = 1e4;  // N/m, of the object between the arms
inline constexpr InternalForce kSoft{.admittance = 4e-4};

inline double way(const Pose& a, const Pose& b) { return (a.translation() - b.translation()).norm(); }
inline double turn(const Pose& a, const Pose& b) { return rotation_vector(a.linear().transpose() * b.linear()).norm(); }

/// Arms with random bases that hold an elastic object at random grasps. The error of each grasp, up to `error` m and 5
/// times that in rad, is relative to the unloaded object.
class ElasticObject {
 public:
  explicit ElasticObject(int count, double error = 0) {
    std::vector<Pose> starts;
    std::vector<Eigen::Vector3d> places;
    for (int i = 0; i < count; ++i) {
      bases.push_back(random_pose(2, 0.8));
      grasps.push_back(random_pose(0.3, 0.8) * Eigen::Translation3d(0.1 * i, 0, 0));
      natural.push_back(grasps.back() * random_pose(error, 5 * error));
      starts.push_back(bases.back().inverse() * path[0] * grasps.back());
      places.push_back(grasps.back().translation());
    }
    team = std::make_unique<FreeTeam>(starts);
    internal = InternalWrench(places, kSoft.length);
  }
  std::vector<CooperatingArm> arms(bool with_wrench) {
    std::vector<CooperatingArm> arms;
    for (std::size_t i = 0; i < bases.size(); ++i) {
      CooperatingArm arm{team->arms[i].get(), bases[i], nullptr};
      if (with_wrench) arm.wrench = [this, i] { return wrench(i); };
      arms.push_back(arm);
    }
    return arms;
  }
  /// The wrench on arm `i`: a spring to the pose that fits all arms best.
  Wrench wrench(std::size_t arm) const {
    const auto size = static_cast<Eigen::Index>(6 * bases.size());
    Eigen::VectorXd off(size), part(size);
    for (std::size_t i = 0; i < bases.size(); ++i) {
      const Pose seen = there().inverse() * bases[i] * team->members[i]->state.desired_pose;
      off.segment<6>(static_cast<Eigen::Index>(6 * i)) << seen.translation() - natural[i].translation(),
          kSoft.length * rotation_vector(seen.linear() * natural[i].linear().transpose());
    }
    internal.of(off, part);
    const Twist force = -kStiffness * part.segment<6>(static_cast<Eigen::Index>(6 * arm));
    const Eigen::Matrix3d axes = grasps[arm].linear().transpose();
    Wrench wrench;
    wrench << axes * force.head<3>(), kSoft.length * (axes * force.tail<3>());
    return wrench;
  }
  /// Pose of the object from the commanded tools and the grasps at the start.
  Pose carried(std::size_t arm, std::size_t step) const {
    return bases[arm] * team->members[arm]->commands[step].pose * grasps[arm].inverse();
  }
  /// The least internal displacement: the difference of the tools from a rigid hold of the object at `pose`.
  double misfit(const Pose& pose) const {
    double most = 0;
    for (std::size_t i = 0; i < bases.size(); ++i)
      most = std::max(most, way(bases[i] * team->members[i]->state.desired_pose, pose * grasps[i]));
    return most;
  }
  Outcome move(Generator& motion) {
    carrying = dynamic_cast<const CooperativeMotion*>(&motion);
    return Move(team->list(), {}, motion);
  }
  /// Initial estimate of the object's pose for the spring.
  Pose there() const { return carrying != nullptr ? carrying->object() : path[0]; }

  std::vector<Pose> path{random_pose(0.5, 0.5), random_pose(0.5, 0.5) * Eigen::Translation3d(0.01, 0, 0),
                         random_pose(0.5, 0.5) * Eigen::Translation3d(0, 0.01, 0)};
  const CooperativeMotion* carrying = nullptr;
  std::vector<Pose> bases, grasps, natural;
  std::unique_ptr<FreeTeam> team;
  InternalWrench internal;
};

}  // namespace mrroc::fakes
