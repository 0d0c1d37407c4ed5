#include "language/cooperation/object_path.hpp"

#include <limits>

#include "language/property.hpp"
#include "language/random_values.hpp"

namespace mrroc::object_path_test {
namespace {

using Eigen::Vector3d;
using fakes::check_property;
using fakes::pick;
using fakes::random_pose;

constexpr int kPathCases = 100;
constexpr double kNoTime = std::numeric_limits<double>::quiet_NaN();

double distance(const Pose& a, const Pose& b) {
  return (a.translation() - b.translation()).norm() + rotation_vector(a.linear().transpose() * b.linear()).norm();
}

struct RandomPath {
  std::vector<Pose> poses;
  CooperativeLimits limits;
  RandomPath() {
    const int count = pick(2, 5);
    for (int i = 0; i < count; ++i) poses.push_back(random_pose(0.5, 0.8) * Eigen::Translation3d(0.01 * i, 0, 0));
    limits.speed = 0.01 * pick(1, 30);
    limits.acceleration = 0.01 * pick(2, 50);
    limits.angular_speed = 0.01 * pick(5, 50);
    limits.angular_acceleration = 0.01 * pick(5, 100);
  }
};

/// Twist by central difference, the angular part in the path's axes.
Twist twist_at(const ObjectPath& path, double t, double h) {
  const Pose before = path.at(t - h), after = path.at(t + h);
  Twist twist;
  twist << (after.translation() - before.translation()) / (2 * h),
      rotation_vector(after.linear() * before.linear().transpose()) / (2 * h);
  return twist;
}

TEST(ObjectPath, LeadsFromTheFirstPoseToTheLastAndRestsThere) {
  check_property(kPathCases, [] {
    const RandomPath random;
    const ObjectPath path(random.poses, random.limits);
    RC_ASSERT(distance(path.at(0), random.poses.front()) < 1e-9);
    RC_ASSERT(distance(path.at(-1), random.poses.front()) < 1e-9);
    RC_ASSERT(distance(path.at(path.duration()), random.poses.back()) < 1e-9);
    RC_ASSERT(distance(path.at(path.duration() + 5), random.poses.back()) < 1e-9);
    RC_ASSERT(twist_at(path, 0, 1e-4).norm() < 1e-5);
    RC_ASSERT(twist_at(path, path.duration(), 1e-4).norm() < 1e-5);
  });
}

TEST(ObjectPath, PassesEveryPose) {
  check_property(kPathCases, [] {
    const RandomPath random;
    const ObjectPath path(random.poses, random.limits);
    const double step = path.duration() / 20000;
    std::size_t next = 0;
    double nearest = INFINITY;
    for (int k = 0; k <= 20000 && next < random.poses.size(); ++k) {
      const double off = distance(path.at(k * step), random.poses[next]);
      nearest = std::min(nearest, off);
      if (nearest < 1e-3) ++next, nearest = INFINITY;
    }
    RC_ASSERT(next == random.poses.size());
  });
}

TEST(ObjectPath, KeepsItsLimits) {
  check_property(kPathCases, [] {
    const RandomPath random;
    const CooperativeLimits& limits = random.limits;
    const ObjectPath path(random.poses, limits);
    constexpr double kStep = 1e-3;
    const int count = static_cast<int>(std::min(path.duration() / kStep, 20000.0));
    const double from = 0.01 * pick(0, 100) * (path.duration() - count * kStep);
    for (int k = 1; k < count; ++k) {
      const double t = from + k * kStep;
      const Twist twist = twist_at(path, t, 0.5 * kStep);
      const Twist rate =
          (twist_at(path, t + 0.5 * kStep, 0.5 * kStep) - twist_at(path, t - 0.5 * kStep, 0.5 * kStep)) / kStep;
      RC_ASSERT(twist.head<3>().norm() < limits.speed * 1.001);
      RC_ASSERT(twist.tail<3>().norm() < limits.angular_speed * 1.001);
      RC_ASSERT(rate.head<3>().norm() < limits.acceleration * 1.001);
      RC_ASSERT(rate.tail<3>().norm() < limits.angular_acceleration * 1.001);
    }
  });
}

TEST(ObjectPath, PathOfTwoPosesIsStraightAndAboutOneAxis) {
  check_property(kPathCases, [] {
    const Pose from = random_pose(0.5, 0.8), to = random_pose(0.5, 0.8) * Eigen::Translation3d(0.01, 0, 0);
    const ObjectPath path({from, to}, {});
    const Vector3d way = to.translation() - from.translation();
    const Vector3d turn = rotation_vector(from.linear().transpose() * to.linear());
    for (int k = 0; k <= 100; ++k) {
      const Pose there = path.at(0.01 * k * path.duration());
      const double share = (there.translation() - from.translation()).norm() / way.norm();
      RC_ASSERT((there.translation() - from.translation() - share * way).norm() < 1e-9);
      RC_ASSERT((rotation_vector(from.linear().transpose() * there.linear()) - share * turn).norm() < 1e-9);
    }
  });
}

TEST(ObjectPath, ReachesOneOfItsLimits) {
  const Pose from = Pose::Identity();
  const ObjectPath far({from, from * Eigen::Translation3d(1, 0, 0)}, {.speed = 0.1, .acceleration = 1});
  EXPECT_NEAR(twist_at(far, 0.5 * far.duration(), 1e-3).norm(), 0.098, 1e-6);
  EXPECT_LT(far.duration(), 10.5);
}

TEST(ObjectPath, RestartsFromTheNearestPoseAhead) {
  check_property(kPathCases, [] {
    const RandomPath random;
    ObjectPath path(random.poses, random.limits);
    const double t = 0.01 * pick(0, 100) * path.duration();
    const Pose stopped = path.at(t + 0.05);
    const Pose place = path.restart(t, stopped, 1.0);
    RC_ASSERT(distance(place, stopped) < 0.02);
    RC_ASSERT(distance(path.at(0), place) < 1e-9);
    RC_ASSERT(twist_at(path, 0, 1e-4).norm() < 1e-5);
    RC_ASSERT(distance(path.at(path.duration()), random.poses.back()) < 1e-9);
  });
}

TEST(ObjectPath, PathOfOnePoseStays) {
  const Pose here(Eigen::Translation3d(1, 2, 3));
  const ObjectPath path({here}, {});
  EXPECT_EQ(path.duration(), 0);
  EXPECT_LT(distance(path.at(7), here), 1e-12);
}

TEST(ObjectPath, RefusesInvalidArguments) {
  const Pose here = Pose::Identity(), there(Eigen::Translation3d(1, 0, 0));
  Pose bad = here, turned = there;
  bad.linear() *= 2;
  turned.linear() = exp_rotation({0, 0, 3.1});
  const auto make = [](const std::vector<Pose>& poses, const CooperativeLimits& limits) { ObjectPath{poses, limits}; };
  EXPECT_NO_THROW(make({here, there}, {}));
  EXPECT_THROW(make({}, {}), NonFatalError);
  EXPECT_THROW(make({here, bad}, {}), NonFatalError);
  EXPECT_THROW(make({here, there, there}, {}), NonFatalError);
  EXPECT_THROW(make({here, turned}, {}), NonFatalError);
  EXPECT_THROW(make({here, there}, {.speed = 0}), NonFatalError);
  EXPECT_THROW(make({here, there}, {.acceleration = kNoTime}), NonFatalError);
  EXPECT_THROW(make({here, there}, {.angular_speed = -1}), NonFatalError);
  EXPECT_THROW(make({here, there}, {.angular_acceleration = 0}), NonFatalError);
}

}  // namespace
}  // namespace mrroc::object_path_test
