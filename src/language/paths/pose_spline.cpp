#include "mrroc/generators/pose_spline.hpp"

#include <cmath>

#include "geometry/knot_rates.hpp"
#include "geometry/near_places.hpp"
#include "language/paths/tool_path.hpp"

namespace mrroc {

namespace {

constexpr const char* kName = "PoseSpline";

/// The pieces of a cubic or quintic spline through poses.
std::unique_ptr<PiecedPath> smooth(const std::vector<Pose>& poses, const std::vector<double>& knots, SplineKind kind,
                                   SplineEnds ends) {
  // position, and the sum of the turns
  Eigen::MatrixXd values(poses.size(), 6);
  Eigen::Vector3d turned = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < poses.size(); ++i) {
    if (i > 0) turned += turn_between(poses[i - 1], poses[i]);
    values.row(static_cast<Eigen::Index>(i)) << poses[i].translation().transpose(), turned.transpose();
  }
  const KnotRates rates =
      knot_rates(kind == SplineKind::cubic ? SplineOrder::cubic : SplineOrder::quintic, ends, knots, values);
  const auto knot = [&](std::size_t i) {
    const auto row = static_cast<Eigen::Index>(i);
    return PathPose{poses[i], rates.first.row(row).transpose(), rates.second.row(row).transpose()};
  };
  auto path = std::make_unique<PiecedPath>();
  for (std::size_t i = 1; i < poses.size(); ++i) path->add(knot(i - 1), knot(i), knots[i] - knots[i - 1]);
  return path;
}

/// Straight pieces; when they are timed each of them begins and ends at rest, by 10 u^3 - 15 u^4 + 6 u^5.
std::unique_ptr<PiecedPath> straight(const std::vector<Pose>& poses, const std::vector<double>& knots, bool timed) {
  auto path = std::make_unique<PiecedPath>();
  for (std::size_t i = 1; i < poses.size(); ++i) {
    const double length = knots[i] - knots[i - 1];
    LineEnds line = line_between(poses[i - 1], poses[i], length);
    if (timed) line.from.first = line.to.first = Twist::Zero();
    path->add(line.from, line.to, length);
  }
  return path;
}

}  // namespace

PoseSpline::PoseSpline(Robot& robot, const std::vector<Pose>& poses, SplineKind kind, const PathLimits& limits)
    : PathGenerator(robot, kName), timed_(false), kind_(kind), limits_(limits) {
  check_limits(limits, kName);
  if (poses.empty()) throw NonFatalError(ErrorCode::invalid_argument, std::string{kName} + " without a pose");
  for (const Pose& pose : poses) poses_.push_back({checked_pose(pose, kName), 0});
}

PoseSpline::PoseSpline(Robot& robot, std::vector<TimedPose> poses, SplineKind kind)
    : PathGenerator(robot, kName), poses_(std::move(poses)), timed_(true), kind_(kind) {
  if (poses_.empty()) throw NonFatalError(ErrorCode::invalid_argument, std::string{kName} + " without a pose");
  double last = 0;
  for (TimedPose& point : poses_) {
    point.pose = checked_pose(point.pose, kName);
    if (!(point.time > last) || !std::isfinite(point.time))
      throw NonFatalError(ErrorCode::invalid_argument, std::string{kName} + ": time " + std::to_string(point.time) +
                                                           " s after " + std::to_string(last) +
                                                           " s, expected finite times that ascend from above 0");
    last = point.time;
  }
}

std::unique_ptr<RobotPath> PoseSpline::path_from(const JointVector& joints) {
  std::vector<Pose> poses{robot().kinematics().direct(joints)};
  std::vector<double> knots{0};
  const auto pose = [&](std::size_t place) -> const Pose& {
    return place == 0 ? poses.front() : poses_[place - 1].pose;
  };
  // poses with times are all passed: the times may hold the tool there
  const auto near = [&](std::size_t a, std::size_t b) { return !timed_ && are_near(pose(a), pose(b)); };
  std::vector<std::size_t> places = distinct_places(poses_.size(), near);
  places.erase(places.begin());
  poses.reserve(places.size() + 1);
  for (const std::size_t place : places) {
    const double time = full_speed_time(poses.back(), pose(place), limits_.speed, limits_.angular_speed);
    if (!timed_ && time < ToolPath::kShortest) continue;
    knots.push_back(timed_ ? poses_[place - 1].time : knots.back() + time);
    poses.push_back(pose(place));
  }
  if (poses.size() < 2) return nullptr;
  ToolPath::Plan plan;
  plan.waypoints = knots;
  plan.stops = kind_ == SplineKind::linear && !timed_ ? knots : std::vector<double>{0, knots.back()};
  plan.timed = timed_;
  plan.limits = limits_;
  if (kind_ == SplineKind::linear) {
    plan.path = straight(poses, knots, timed_);
  } else {
    plan.path = smooth(poses, knots, kind_, timed_ ? SplineEnds::at_rest : SplineEnds::straight);
  }
  return std::make_unique<ToolPath>(robot(), joints, std::move(plan));
}

}  // namespace mrroc
