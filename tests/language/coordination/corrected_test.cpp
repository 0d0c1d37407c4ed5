// Corrections of the MP's trajectory within bounds.
#include "mrroc/generators/corrected.hpp"

#include "geometry/rigid_motion.hpp"
#include "language/coordination/fake_mp.hpp"
#include "language/fakes.hpp"
#include "language/property.hpp"
#include "language/random_values.hpp"
#include "mrroc/move.hpp"

namespace mrroc::fakes::corrected_test {
namespace {

Pose at(const Eigen::Vector3d& way, const Eigen::Vector3d& turn) {
  Pose pose = Pose::Identity();
  pose.translation() = way;
  pose.linear() = exp_rotation(turn);
  return pose;
}

/// Runs `steps` steps of an MP that wishes the arm at rest; `look` sees the correction after each.
void run(const Corrected::Correction& correction, const CorrectionLimits& limits, std::uint64_t steps,
         const std::function<void(const Corrected&)>& look) {
  FakeTask task;
  FakeMp mp;
  const auto arm = task.robot("arm");
  mp.items = {item(CommandKind::query)};
  mp.make = [](const std::vector<RobotState>&) { return item(CommandKind::pose).command; };
  Superior superior(mp);
  Corrected corrected(superior, *arm, correction, limits);
  corrected.until(When{"over", [&] {
                         look(corrected);
                         return mp.replies.size() > steps;
                       }});
  Move({*arm}, {}, corrected);
  EXPECT_LT((mp.replies.back().desired_pose.matrix() - corrected.correction().matrix()).norm(), 1e-9);
}

TEST(Corrected, ReachesTheCorrectionWithoutPassingIt) {
  check_property(100, [] {
    const Eigen::Vector3d way = random_vector(0.005), turn = random_vector(0.02);
    double farthest = 0;
    Pose last = Pose::Identity();
    run([&] { return at(way, turn); }, {}, 400,
        [&](const Corrected& corrected) {
          last = corrected.correction();
          farthest = std::max(farthest, last.translation().norm());
          RC_ASSERT(!corrected.saturated());
        });
    RC_ASSERT((last.translation() - way).norm() < 1e-6);
    RC_ASSERT((rotation_vector(last.linear()) - turn).norm() < 1e-5);
    RC_ASSERT(farthest <= 1.01 * way.norm() + 1e-9);
  });
}

TEST(Corrected, KeepsItsBoundsWhateverIsAsked) {
  check_property(200, [] {
    Eigen::Vector3d way = random_vector(0.1), turn = random_vector(0.5);
    const CorrectionLimits limits;
    const double step = 0.02;
    int asked = 0;
    Eigen::Vector3d before = Eigen::Vector3d::Zero(), speed_before = Eigen::Vector3d::Zero();
    run(
        [&] {
          if (++asked % 37 == 0) way = random_vector(0.1), turn = random_vector(0.5);
          return at(way, turn);
        },
        limits, 300,
        [&](const Corrected& corrected) {
          const Eigen::Vector3d here = corrected.correction().translation();
          const Eigen::Vector3d speed = (here - before) / step;
          RC_ASSERT(here.norm() <= 1.05 * limits.travel);
          RC_ASSERT(rotation_vector(corrected.correction().linear()).norm() <= 1.05 * limits.turn);
          RC_ASSERT(speed.norm() <= 1.05 * limits.speed);
          RC_ASSERT((speed - speed_before).norm() / step <= 1.05 * limits.acceleration);
          before = here;
          speed_before = speed;
        });
  });
}

TEST(Corrected, SaysThatItIsSaturated) {
  bool saturated = false;
  run(
      [] {
        return at({0.05, 0, 0}, Eigen::Vector3d::Zero());
      },
      {}, 10, [&](const Corrected& corrected) { saturated = corrected.saturated(); });
  EXPECT_TRUE(saturated);
}

TEST(Corrected, RefusesWrongArguments) {
  FakeTask task;
  FakeMp mp;
  const auto arm = task.robot("arm");
  Superior superior(mp);
  const auto nothing = [] { return Pose{Pose::Identity()}; };
  EXPECT_THROW(Corrected(superior, *arm, nullptr), NonFatalError);
  EXPECT_THROW(Corrected(superior, *arm, nothing, {.travel = 0}), NonFatalError);
  EXPECT_THROW(Corrected(superior, *arm, nothing, {.turn = -1}), NonFatalError);
  EXPECT_THROW(Corrected(superior, *arm, nothing, {.speed = 0}), NonFatalError);
  EXPECT_THROW(Corrected(superior, *arm, nothing, {.angular_speed = NAN}), NonFatalError);
  EXPECT_THROW(Corrected(superior, *arm, nothing, {.acceleration = 0}), NonFatalError);
  EXPECT_THROW(Corrected(superior, *arm, nothing, {.angular_acceleration = 0}), NonFatalError);
}

TEST(Corrected, NumbersThatAreNotFiniteAreAnErrorOfTheStep) {
  EXPECT_THROW(run(
                   [] {
                     return at({NAN, 0, 0}, Eigen::Vector3d::Zero());
                   },
                   {}, 10, [](const Corrected&) {}),
               NonFatalError);
}

}  // namespace
}  // namespace mrroc::fakes::corrected_test
