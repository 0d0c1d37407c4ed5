#include "kinematics/closed_form.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "kinematics/newton.hpp"

namespace mrroc::kinematics {

namespace {

constexpr int kNewtonSteps = 8;
constexpr int kManySteps = 40;     // from the posture of a similar arm
constexpr double kAligned = 1e-7;  // sine of the angle between two axes that count as one
constexpr double kSame = 1e-6;     // rad: two postures that are one

Eigen::Matrix3d turn(const Eigen::Vector3d& axis, double angle) noexcept {
  return Eigen::AngleAxisd(angle, axis).toRotationMatrix();
}

bool parallel(const Eigen::Vector3d& a, const Eigen::Vector3d& b) noexcept {
  return a.cross(b).norm() < ClosedForm::kTolerance;
}

/// The point of line (o1, h1) nearest to line (o2, h2), which is not parallel to it.
Eigen::Vector3d nearest(const Eigen::Vector3d& o1, const Eigen::Vector3d& h1, const Eigen::Vector3d& o2,
                        const Eigen::Vector3d& h2) noexcept {
  const Eigen::Vector3d between = o2 - o1;
  const double cosine = h1.dot(h2);
  return o1 + h1 * ((between.dot(h1) - between.dot(h2) * cosine) / (1 - cosine * cosine));
}

double distance(const Eigen::Vector3d& point, const Eigen::Vector3d& o, const Eigen::Vector3d& h) noexcept {
  return (point - o).cross(h).norm();
}

double wrapped(double angle) noexcept { return std::remainder(angle, 2 * std::numbers::pi); }

/// The values of an angle: its solutions, or `near` when every angle is one.
Angles or_near(Angles angles, double near, bool& singular) noexcept {
  if (!angles.free) return angles;
  singular = true;
  return {{near, 0}, 1, angles.exact};
}

Eigen::Vector3d any_across(const Eigen::Vector3d& axis) noexcept { return axis.unitOrthogonal(); }

}  // namespace

std::string_view name_of(Structure structure) noexcept {
  switch (structure) {
    case Structure::none:
      return "no closed form";
    case Structure::wrist_after_parallel:
      return "spherical wrist, axes 2 and 3 parallel";
    case Structure::wrist_after_parallel_base:
      return "spherical wrist, axes 1 and 2 parallel";
    case Structure::wrist_after_crossing_base:
      return "spherical wrist, axes 1 and 2 meet";
    case Structure::wrist_after_crossing_elbow:
      return "spherical wrist, axes 2 and 3 meet";
    case Structure::three_parallel:
      return "axes 2, 3 and 4 parallel";
  }
  return "";
}

/// What `solve` looks for and has found.
struct ClosedForm::Search {
  const Pose& flange;
  const JointVector& near;
  double tolerance;
  Target target;
  Postures& postures;
};

ClosedForm::ClosedForm(const SerialChain& chain, double distance)
    : chain_(chain), steps_(distance > kTolerance ? kManySteps : kNewtonSteps) {
  structure_ = recognise(distance);
}

Structure ClosedForm::recognise(double tolerance) {
  if (chain_.size() != 6) return Structure::none;
  for (int i = 0; i < 6; ++i)
    if (chain_.slides(i)) return Structure::none;
  SerialChain::Axes axes;
  chain_.compute(JointVector::Zero(6), axes);
  std::copy_n(axes.axis.begin(), 6, h_.begin());
  std::copy_n(axes.origin.begin(), 6, o_.begin());
  flange_rotation_ = axes.flange.linear();
  const auto meet = [this, tolerance](std::size_t i, std::size_t j, Eigen::Vector3d& point) {
    if (parallel(h_[i], h_[j])) return false;
    point = nearest(o_[i], h_[i], o_[j], h_[j]);
    return distance(point, o_[j], h_[j]) < tolerance;
  };
  Eigen::Vector3d point;
  const bool last_meet = meet(4, 5, point);
  if (last_meet && parallel(h_[1], h_[2]) && parallel(h_[2], h_[3]) && !parallel(h_[0], h_[1])) {
    o_[4] = o_[5] = point;
    flange_offset_ = axes.flange.translation() - point;
    return Structure::three_parallel;
  }
  if (!last_meet || parallel(h_[3], h_[4]) || distance(point, o_[3], h_[3]) >= tolerance) return Structure::none;
  o_[3] = o_[4] = o_[5] = point;
  flange_offset_ = axes.flange.translation() - point;
  if (parallel(h_[1], h_[2]) && !parallel(h_[0], h_[1])) return Structure::wrist_after_parallel;
  if (parallel(h_[0], h_[1]) && !parallel(h_[1], h_[2])) return Structure::wrist_after_parallel_base;
  if (meet(0, 1, point)) {
    o_[0] = o_[1] = point;
    return Structure::wrist_after_crossing_base;
  }
  if (meet(1, 2, point)) {
    o_[1] = o_[2] = point;
    return Structure::wrist_after_crossing_elbow;
  }
  return Structure::none;
}

void ClosedForm::solve(const Pose& flange, const JointVector& near, double tolerance,
                       Postures& postures) const noexcept {
  postures.count = 0;
  postures.singular = false;
  if (structure_ == Structure::none || near.size() != 6) return;
  Search search{flange, near, tolerance, {}, postures};
  search.target.rotation = flange.linear() * flange_rotation_.transpose();
  search.target.reach = flange.translation() - search.target.rotation * flange_offset_ - o_[0];
  structure_ == Structure::three_parallel ? solve_three_parallel(search) : solve_arm(search);
}

/// The first three joints: reach = R1 (p12 + R2 (p23 + R3 p34)).
void ClosedForm::solve_arm(Search& search) const noexcept {
  const Eigen::Vector3d &reach = search.target.reach, p12 = o_[1] - o_[0], p23 = o_[2] - o_[1], p34 = o_[3] - o_[2];
  bool& singular = search.postures.singular;
  const auto& near = search.near;
  const auto each = [](const Angles& angles, const auto& use) {
    for (int i = 0; i < angles.count; ++i) use(angles.value[static_cast<std::size_t>(i)]);
  };
  switch (structure_) {
    case Structure::wrist_after_parallel:
      // rotations about h2 and h3 change no component along h2
      each(or_near(rotate_to_plane(h_[1], -h_[0], reach, h_[1].dot(p12 + p23 + p34)), near[0], singular),
           [&](double q1) {
             const Eigen::Vector3d from_shoulder = turn(h_[0], -q1) * reach - p12;
             each(or_near(rotate_to_distance(h_[2], p34, -p23, from_shoulder.norm()), near[2], singular),
                  [&](double q3) {
                    const Angles q2 = rotate_onto(h_[1], p23 + turn(h_[2], q3) * p34, from_shoulder);
                    each(or_near(q2, near[1], singular), [&](double q) { solve_wrist(search, q1, q, q3); });
                  });
           });
      break;
    case Structure::wrist_after_parallel_base:
      each(or_near(rotate_to_plane(h_[0], h_[2], p34, h_[0].dot(reach - p12 - p23)), near[2], singular),
           [&](double q3) {
             const Eigen::Vector3d outer = p23 + turn(h_[2], q3) * p34;
             each(or_near(rotate_to_distance(h_[1], outer, -p12, reach.norm()), near[1], singular), [&](double q2) {
               const Angles q1 = rotate_onto(h_[0], p12 + turn(h_[1], q2) * outer, reach);
               each(or_near(q1, near[0], singular), [&](double q) { solve_wrist(search, q, q2, q3); });
             });
           });
      break;
    case Structure::wrist_after_crossing_base:
      each(or_near(rotate_to_distance(h_[2], p34, -p23, reach.norm()), near[2], singular), [&](double q3) {
        const AnglePairs pairs = rotate_both(-h_[0], reach, h_[1], p23 + turn(h_[2], q3) * p34);
        for (std::size_t i = 0; i < static_cast<std::size_t>(pairs.count); ++i)
          solve_wrist(search, pairs.value[i], pairs.other[i], q3);
      });
      break;
    case Structure::wrist_after_crossing_elbow:
      each(or_near(rotate_to_distance(-h_[0], reach, p12, p34.norm()), near[0], singular), [&](double q1) {
        const AnglePairs pairs = rotate_both(-h_[1], turn(h_[0], -q1) * reach - p12, h_[2], p34);
        for (std::size_t i = 0; i < static_cast<std::size_t>(pairs.count); ++i)
          solve_wrist(search, q1, pairs.value[i], pairs.other[i]);
      });
      break;
    default:
      break;
  }
}

/// The last three joints from the orientation that they have to give.
void ClosedForm::solve_wrist(Search& search, double q1, double q2, double q3) const noexcept {
  const Eigen::Matrix3d rotation =
      (turn(h_[0], q1) * turn(h_[1], q2) * turn(h_[2], q3)).transpose() * search.target.rotation;
  const Eigen::Vector3d last = rotation * h_[5];
  const Angles bend = rotate_to_plane(h_[3], h_[4], h_[5], h_[3].dot(last));
  for (int i = 0; i < bend.count; ++i) {
    const double q5 = bend.value[static_cast<std::size_t>(i)];
    const Eigen::Vector3d bent = turn(h_[4], q5) * h_[5];
    double q4 = search.near[3], q6 = 0;
    if (bent.cross(h_[3]).norm() < kAligned) {
      search.postures.singular = true;
      const Eigen::Vector3d across = any_across(h_[5]);
      q6 = rotate_onto(h_[5], across, (turn(h_[3], q4) * turn(h_[4], q5)).transpose() * rotation * across).value[0];
    } else {
      q4 = rotate_onto(h_[3], bent, last).value[0];
      q6 = rotate_onto(-h_[5], turn(h_[4], -q5) * h_[3], rotation.transpose() * h_[3]).value[0];
    }
    add(search, {q1, q2, q3, q4, q5, q6});
  }
}

void ClosedForm::solve_three_parallel(Search& search) const noexcept {
  const Eigen::Vector3d& reach = search.target.reach;
  const Eigen::Matrix3d& rotation = search.target.rotation;
  bool& singular = search.postures.singular;
  const double along = h_[1].dot(o_[4] - o_[0]);
  const Angles column = or_near(rotate_to_plane(h_[1], -h_[0], reach, along), search.near[0], singular);
  for (int i = 0; i < column.count; ++i) {
    const double q1 = column.value[static_cast<std::size_t>(i)];
    const Eigen::Matrix3d arm = turn(h_[0], -q1) * rotation;  // R(h2, q2 + q3 + q4) R5 R6
    const Angles bend = or_near(rotate_to_plane(h_[1], h_[4], h_[5], h_[1].dot(arm * h_[5])), search.near[4], singular);
    for (int j = 0; j < bend.count; ++j) {
      const double q5 = bend.value[static_cast<std::size_t>(j)];
      const Eigen::Vector3d bent = turn(h_[4], q5) * h_[5];
      if (bent.cross(h_[1]).norm() < kAligned) {
        singular = true;  // axis 6 is parallel to 2, 3, 4
        const double q6 = search.near[5];
        const Eigen::Vector3d across = any_across(h_[1]);
        const Eigen::Matrix3d outer = turn(h_[4], q5) * turn(h_[5], q6);
        solve_planar(search, q1, q5, rotate_onto(h_[1], across, arm * outer.transpose() * across).value[0], q6);
      } else {
        const double sum = rotate_onto(h_[1], bent, arm * h_[5]).value[0];
        const double q6 = rotate_onto(-h_[5], turn(h_[4], -q5) * h_[1], arm.transpose() * h_[1]).value[0];
        solve_planar(search, q1, q5, sum, q6);
      }
    }
  }
}

/// Joints 2, 3, 4 from the angle `sum` of all about h2 and the place of the wrist.
void ClosedForm::solve_planar(Search& search, double q1, double q5, double sum, double q6) const noexcept {
  const Eigen::Vector3d p12 = o_[1] - o_[0], p23 = o_[2] - o_[1], p34 = o_[3] - o_[2], p45 = o_[4] - o_[3];
  const Eigen::Vector3d to_wrist = turn(h_[0], -q1) * search.target.reach - p12 - turn(h_[1], sum) * p45;
  const double sign3 = h_[2].dot(h_[1]) < 0 ? -1 : 1, sign4 = h_[3].dot(h_[1]) < 0 ? -1 : 1;
  // along h2 the place is given by the other joints
  const Eigen::Vector3d flat = to_wrist - h_[1] * h_[1].dot(to_wrist - p23 - p34);
  const Angles elbow =
      or_near(rotate_to_distance(h_[2], p34, -p23, flat.norm()), search.near[2], search.postures.singular);
  for (int i = 0; i < elbow.count; ++i) {
    const double q3 = elbow.value[static_cast<std::size_t>(i)];
    const Angles shoulder =
        or_near(rotate_onto(h_[1], p23 + turn(h_[2], q3) * p34, flat), search.near[1], search.postures.singular);
    const double q2 = shoulder.value[0];
    add(search, {q1, q2, q3, sign4 * (sum - q2 - sign3 * q3), q5, q6});
  }
}

void ClosedForm::add(Search& search, const std::array<double, 6>& joints) const noexcept {
  Postures& postures = search.postures;
  if (postures.count == kMaxPostures) return;
  JointVector& found = postures.joints[postures.count];
  found = Eigen::Map<const Eigen::Matrix<double, 6, 1>>(joints.data());
  if (!improve(chain_, search.flange, search.tolerance, steps_, found)) return;
  for (double& joint : found) joint = wrapped(joint);
  for (std::size_t i = 0; i < postures.count; ++i) {
    double difference = 0;
    for (int j = 0; j < 6; ++j) difference = std::max(difference, std::abs(wrapped(found[j] - postures.joints[i][j])));
    if (difference < kSame) return;
  }
  ++postures.count;
}

}  // namespace mrroc::kinematics
