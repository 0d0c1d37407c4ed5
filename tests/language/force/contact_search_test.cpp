#include "mrroc/generators/contact_search.hpp"

#include <limits>

#include "language/force/force_flyer.hpp"
#include "language/property.hpp"
#include "language/random_values.hpp"
#include "mrroc/conditions/elapsed_steps.hpp"
#include "mrroc/move.hpp"

namespace mrroc::contact_search_test {
namespace {

using Eigen::Vector3d;
using fakes::check_property;
using fakes::ForceFlyer;
using fakes::pick;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

Pose turned_by(const Vector3d& turn, const Vector3d& place = Vector3d::Zero()) {
  Pose pose = Pose::Identity();
  pose.translation() = place;
  pose.linear() = exp_rotation(turn);
  return pose;
}

Pose random_pose() {
  return turned_by(0.01 * Vector3d(pick(-100, 100), pick(-100, 100), pick(-100, 100)),
                   0.001 * Vector3d(pick(-20, 20), pick(-20, 20), pick(-20, 20)));
}

TEST(ContactSearch, FindsASurfaceAtTheNodesOfAGrid) {
  check_property(20, [] {
    // the grid's z axis points down onto the top of a ball; beneath a corner of the grid there is no surface
    const double radius = 0.3, stiffness = 1000 * pick(2, 10), force = pick(2, 5);
    const Vector3d centre(0.03, 0.03, -radius);
    fakes::SpringSurface surface = fakes::ball(centre, radius, stiffness);
    ForceFlyer task(turned_by({std::numbers::pi, 0, 0.01 * pick(-300, 300)}, {0, 0, 0.03}), surface);
    task.felt = [&](const Pose& tool, const Twist& twist) {
      const bool hole = tool.translation().head<2>().norm() < 0.01;
      return hole ? Wrench{Wrench::Zero()} : surface(tool, twist);
    };
    const int columns = pick(1, 3), rows = pick(1, 3);
    const Pose frame = turned_by({std::numbers::pi, 0, 0}, {0, 0, 0.02});  // y in reverse
    ContactSearch search(*task.arm, grid_of_probes(frame, columns, rows, 0.02, 0.04), {.speed = 0.01, .force = force});
    const Eigen::Matrix3d orientation = task.pose.linear();
    double most = 0;
    task.on_tick = [&](Tick, const Wrench& wrench) { most = std::max(most, wrench.head<3>().norm()); };
    const Outcome end = Move({*task.arm}, {}, search.until(ElapsedSteps{100000}));
    RC_ASSERT(end.ending == Ending::generator);
    RC_ASSERT(search.count() == columns * rows - 1);
    RC_ASSERT(search.touched().size() == static_cast<std::size_t>(columns * rows));
    int found = 0;
    for (std::size_t i = 0; i < search.touched().size(); ++i) {
      const int row = static_cast<int>(i) / columns, place = static_cast<int>(i) % columns;
      const int column = row % 2 == 0 ? place : columns - 1 - place;
      if (column == 0 && row == 0) {
        RC_ASSERT(!search.touched()[i].has_value());
        continue;
      }
      ++found;
      const Vector3d touched = *search.touched()[i];
      RC_ASSERT((touched.head<2>() - Eigen::Vector2d(0.02 * column, -0.02 * row)).norm() < 1e-3);
      // along z it presses with the force; the ball's force is inclined
      const double inside = radius - (touched - centre).norm();
      RC_ASSERT(std::abs(stiffness * inside * (touched - centre).normalized().z() - force) < 0.1 * force);
    }
    RC_ASSERT(found == search.count());
    RC_ASSERT(rotation_vector(orientation.transpose() * task.pose.linear()).norm() < 1e-6);
    RC_ASSERT(most < 3.5 * force + stiffness * 0.01 * 0.03);
    RC_ASSERT((task.pose.translation() - grid_of_probes(frame, columns, rows, 0.02, 0.04).back().start).norm() < 2e-3);
  });
}

TEST(ContactSearch, SearchesInSeveralDirectionsUntilTheFirstContact) {
  check_property(30, [] {
    const Pose home = random_pose();
    const Vector3d normal = -home.linear().col(0);
    ForceFlyer task(home, fakes::plane(home.translation() + 0.01 * home.linear().col(0), normal, 3000));
    std::vector<Probe> probes;
    const int first = pick(0, 3);
    const std::vector<Vector3d> directions{home.linear().col(1), home.linear().col(2), -home.linear().col(1),
                                           -home.linear().col(2)};
    for (int i = 0; i < 4; ++i) {
      if (i == first) probes.push_back({home.translation(), home.linear().col(0), 0.02});
      probes.push_back({home.translation(), directions[static_cast<std::size_t>(i)], 0.015});
    }
    ContactSearch search(*task.arm, probes, {.speed = 0.02, .force = 4, .first_only = true});
    const Outcome end = Move({*task.arm}, {}, search.until(ElapsedSteps{100000}));
    RC_ASSERT(end.ending == Ending::generator);
    RC_ASSERT(search.count() == 1);
    RC_ASSERT(search.touched()[static_cast<std::size_t>(first)].has_value());
    const double depth = (*search.touched()[static_cast<std::size_t>(first)] - home.translation()).dot(-normal) - 0.01;
    RC_ASSERT(std::abs(3000 * depth - 4) < 0.3);
    RC_ASSERT(-task.arm->state().wrench.head<3>().dot(home.linear().transpose() * -normal) > 3);  // rests there
  });
}

TEST(ContactSearch, ThrowsOnAContactBetweenTheProbes) {
  ForceFlyer task(Pose::Identity(), fakes::plane({0.02, 0, 0}, {-1, 0, 0}, 5000));
  const std::vector<Probe> probes{{{0, 0, 0}, {0, 0, 1}, 0.01}, {{0.06, 0, 0}, {0, 0, 1}, 0.01}};
  ContactSearch search(*task.arm, probes, {.speed = 0.01, .force = 4});
  try {
    Move({*task.arm}, {}, search.until(ElapsedSteps{10000}));
    FAIL() << "no error";
  } catch (const NonFatalError& error) {
    EXPECT_EQ(error.code(), ErrorCode::force_limit);
    EXPECT_NE(error.detail().find("probe 2"), std::string::npos) << error.detail();
  }
}

TEST(ContactSearch, ContinuesAfterAPauseAndRestartsWhenUsedAgain) {
  ForceFlyer task(Pose::Identity(), fakes::plane({0, 0, 0.01}, {0, 0, -1}));
  for (int i = 0; i < 5; ++i) {
    task.requests.insert(task.requests.end(), 37, OperatorRequest::none);
    task.requests.insert(task.requests.end(), 10, OperatorRequest::pause);
  }
  const std::vector<Probe> probes{{{0, 0, 0}, {0, 0, 1}, 0.03}, {{0.01, 0, 0}, {0, 0, 1}, 0.03}};
  ContactSearch search(*task.arm, probes, {.speed = 0.01, .force = 3});
  for (int round = 0; round < 2; ++round) {
    Move({*task.arm}, {}, search.until(ElapsedSteps{100000}));
    ASSERT_EQ(search.count(), 2);
    for (const auto& place : search.touched()) EXPECT_NEAR(place->z(), 0.01 + 3.0 / 2000, 2e-4);
  }
}

TEST(ContactSearch, WeightOfTheLoadIsNoContact) {
  const Load load{1.5, {0.01, 0, 0.05}};
  const Pose home = turned_by({0.3, -0.2, 0.1});
  const fakes::SpringSurface plate = fakes::plane({0, 0, 0.01}, {0, 0, -1});
  ForceFlyer task(home, [&](const Pose& tool, const Twist& twist) {
    return Wrench{plate(tool, twist) + weight_of(load, tool.linear())};
  });
  ContactSearch search(*task.arm, {{{0, 0, 0}, {0, 0, 1}, 0.03}}, {.speed = 0.01, .force = 3, .load = load});
  Move({*task.arm}, {}, search.until(ElapsedSteps{100000}));
  ASSERT_EQ(search.count(), 1);
  EXPECT_NEAR(search.touched()[0]->z(), 0.01 + 3.0 / 2000, 2e-4);
}

TEST(ContactSearch, RefusesInvalidArguments) {
  ForceFlyer task(Pose::Identity(), fakes::plane({0, 0, 1}, {0, 0, -1}));
  const Probe good{{0, 0, 0}, {0, 0, 1}, 0.01};
  const auto with = [&](std::vector<Probe> probes, const Probing& probing = {}) {
    ContactSearch{*task.arm, std::move(probes), probing};
  };
  EXPECT_NO_THROW(with({good}));
  EXPECT_THROW(with({}), NonFatalError);
  EXPECT_THROW(with({{{0, kNan, 0}, {0, 0, 1}, 0.01}}), NonFatalError);
  EXPECT_THROW(with({{{0, 0, 0}, {0, 0, 0}, 0.01}}), NonFatalError);
  for (const double bad : {0.0, -1.0, kNan}) {
    EXPECT_THROW(with({{{0, 0, 0}, {0, 0, 1}, bad}}), NonFatalError);
    EXPECT_THROW(with({good}, {.speed = bad}), NonFatalError);
    EXPECT_THROW(with({good}, {.force = bad}), NonFatalError);
    EXPECT_THROW(with({good}, {.travel_speed = bad}), NonFatalError);
    EXPECT_THROW(with({good}, {.acceleration = bad}), NonFatalError);
    EXPECT_THROW(grid_of_probes(Pose::Identity(), 2, 2, bad, 0.01), NonFatalError);
  }
  EXPECT_THROW(grid_of_probes(Pose::Identity(), 0, 2, 0.01, 0.01), NonFatalError);
}

}  // namespace
}  // namespace mrroc::contact_search_test
