// Trajectories from outside, checked as the EDP would.
#include <cmath>
#include <regex>
#include <string>
#include <string_view>
#include <vector>

#include "language/limits.hpp"
#include "language/trajectory/external_rig.hpp"

namespace mrroc::fakes::external_test {
namespace {

/// From `from` by `way`, at rest at both ends: s^3 (10 - 15 s + 6 s^2).
JointTrajectory blend(const JointVector& from, const JointVector& way, double duration, Order order, int points = 200) {
  const auto axes = static_cast<std::size_t>(from.size());
  JointTrajectory trajectory(axes, order, static_cast<std::size_t>(points));
  for (int i = 0; i < points; ++i) {
    const double s = (i + 1.0) / points;
    const double p = s * s * s * (10 + s * (-15 + 6 * s)), v = 30 * s * s * (1 - s) * (1 - s) / duration;
    const double a = 60 * s * (1 - s) * (1 - 2 * s) / (duration * duration);
    std::vector<double> values;
    for (Eigen::Index axis = 0; axis < from.size(); ++axis) values.push_back(from[axis] + p * way[axis]);
    if (order != Order::positions)
      for (Eigen::Index axis = 0; axis < from.size(); ++axis) values.push_back(i + 1 == points ? 0 : v * way[axis]);
    if (order == Order::accelerations)
      for (Eigen::Index axis = 0; axis < from.size(); ++axis) values.push_back(i + 1 == points ? 0 : a * way[axis]);
    trajectory.set_point(static_cast<std::size_t>(i), s * duration, values);
  }
  return trajectory;
}

JointVector small_way(const Rig& rig) {
  JointVector way = rig.joints();
  for (Eigen::Index i = 0; i < way.size(); ++i) way[i] = number(-0.2, 0.2);
  return way;
}

const std::vector<TrajectoryState> kArrival{TrajectoryState::yielded, TrajectoryState::begun, TrajectoryState::arrived,
                                            TrajectoryState::withdrawn};

TEST(External, FollowsAtrajectoryWithinTheLimitsExactly) {
  check_property(20, [] {
    Rig rig(400);
    JointVector from, way;
    rig.before = [&](int step) {
      if (step != 3) return;
      from = rig.joints();
      way = small_way(rig);
      rig.task.link.send(1, blend(from, way, 6, Order::accelerations));
    };
    rig.run();
    RC_ASSERT(rig.task.link.states() == kArrival);
    double most = 0;
    for (std::size_t k = 3; k < rig.ends.size(); ++k) {
      const double s = std::min(1.0, (static_cast<double>(k) - 2) * 0.02 / 6);
      const JointVector wanted = from + s * s * s * (10 + s * (-15 + 6 * s)) * way;
      most = std::max(most, (rig.ends[k].position - wanted).cwiseAbs().maxCoeff());
    }
    RC_ASSERT(most < 2e-5);
    RC_ASSERT(rig.ends.back().position == from + way);
  });
}

TEST(External, PointsOfAnyOrderAndSpeedAreFollowedWithinTheLimits) {
  check_property(60, [] {
    Rig rig(900);
    const auto order = static_cast<Order>(*rc::gen::inRange(1, 4));
    const int points = *rc::gen::inRange(2, 40);
    JointVector end;
    rig.before = [&](int step) {
      if (step != 0) return;
      JointVector last = rig.joints();
      JointTrajectory trajectory(rig.axes(), order, static_cast<std::size_t>(points));
      double time = 0;
      for (int i = 0; i < points; ++i) {
        time += number(0.1, 0.4);
        std::vector<double> values;
        for (Eigen::Index axis = 0; axis < last.size(); ++axis) {
          const AxisParameters& limits = rig.robot->parameters().axes[static_cast<std::size_t>(axis)];
          const double most = 0.09 * limits.velocity_max;
          last[axis] =
              std::clamp(last[axis] + number(-most, most), 0.8 * limits.position_min, 0.8 * limits.position_max);
          values.push_back(last[axis]);
        }
        for (int more = 1; more < static_cast<int>(order); ++more)
          for (Eigen::Index axis = 0; axis < last.size(); ++axis)
            values.push_back(i + 1 == points ? 0 : number(-0.3, 0.3));
        trajectory.set_point(static_cast<std::size_t>(i), time, values);
      }
      end = last;
      rig.task.link.send(1, trajectory);
    };
    rig.run();
    RC_ASSERT(rig.task.link.states() == kArrival);
    RC_ASSERT((rig.ends.back().position - end).cwiseAbs().maxCoeff() < 1e-9);
  });
}

TEST(External, CancelAndReplacementWorkInMotion) {
  check_property(20, [] {
    Rig rig(900);
    const int at = *rc::gen::inRange(5, 150), kind = *rc::gen::inRange(0, 2);
    rig.before = [&](int step) {
      if (step == 0) rig.task.link.send(1, blend(rig.joints(), small_way(rig), 4, Order::velocities));
      if (step != at) return;
      if (kind == 0)
        rig.task.link.cancel(1);
      else
        rig.task.link.send(2, blend(rig.joints(), small_way(rig), 5, Order::positions));
    };
    rig.run();
    std::vector<TrajectoryState> expected{TrajectoryState::yielded, TrajectoryState::begun, TrajectoryState::cancelled};
    if (kind == 1) expected.insert(expected.end(), {TrajectoryState::begun, TrajectoryState::arrived});
    expected.push_back(TrajectoryState::withdrawn);
    RC_ASSERT(rig.task.link.states() == expected);
    RC_ASSERT(rig.ends.back().at_rest());
  });
}

TEST(External, PauseBringsTheRobotToRestOnTheTrajectory) {
  Rig rig(900);
  JointVector from, way;
  for (int i = 0; i < 60; ++i) rig.task.requests.push_back(OperatorRequest::none);
  for (int i = 0; i < 120; ++i) rig.task.requests.push_back(OperatorRequest::pause);
  rig.before = [&](int step) {
    if (step != 0) return;
    from = rig.joints();
    way = JointVector::Constant(from.size(), 0.2);
    rig.task.link.send(1, blend(from, way, 4, Order::accelerations));
  };
  rig.run();
  EXPECT_EQ(rig.task.link.states(), kArrival);
  for (const DesiredState& end : rig.ends) {  // all axes have the same way: on it they are equal
    const JointVector done = end.position - from;
    EXPECT_LT(done.maxCoeff() - done.minCoeff(), 1e-6);
  }
  EXPECT_EQ(rig.ends.back().position, JointVector(from + way));
}

TEST(External, RefusesWhatTheRobotCannotFollowAndContinues) {
  Rig rig(500);
  const auto one_point = [&](std::size_t axis, double value, double time) {
    JointTrajectory trajectory(rig.axes(), Order::positions, 1);
    JointVector to = rig.joints();
    to[static_cast<Eigen::Index>(axis)] += value;
    trajectory.set_point(0, time, {to.data(), static_cast<std::size_t>(to.size())});
    return trajectory;
  };
  rig.before = [&](int step) {
    if (step == 0) rig.task.link.send(1, blend(rig.joints(), JointVector::Constant(6, 0.1), 4, Order::velocities));
    if (step == 10) rig.task.link.send(2, one_point(1, 100, 500));                   // outside the limits
    if (step == 12) rig.task.link.send(3, one_point(2, 0.5, 0.01));                  // too fast
    if (step == 14) rig.task.link.send(4, one_point(0, 0.02, 0));                    // begins elsewhere
    if (step == 16) rig.task.link.send(5, JointTrajectory(3, Order::positions, 1));  // another robot's
    if (step == 18) {
      JointTrajectory bad = one_point(0, 0, 1);
      const double nan[]{std::nan(""), 0, 0, 0, 0, 0};
      bad.set_point(0, 1, nan);
      rig.task.link.send(6, bad);
    }
    if (step == 20) {
      rig.task.link.send(7, blend(rig.joints(), JointVector::Constant(6, 0.1), 4, Order::accelerations));
      rig.task.link.parts.erase(rig.task.link.parts.begin() + 1);  // a part is lost
    }
    if (step == 25)  // in small pieces, each too fast
      rig.task.link.send(8, blend(rig.joints(), JointVector::Constant(6, 3), 0.3, Order::accelerations));
    if (step == 30) rig.task.link.cancel(0);  // of none
  };
  rig.run();
  std::vector<TrajectoryState> expected(11, TrajectoryState::refused);
  expected.at(0) = TrajectoryState::yielded;
  expected.at(1) = TrajectoryState::begun;
  expected.at(9) = TrajectoryState::arrived;
  expected.at(10) = TrajectoryState::withdrawn;
  EXPECT_EQ(rig.task.link.states(), expected);
  for (std::size_t i = 2; i < 9; ++i) {
    EXPECT_EQ(rig.task.link.reports.at(i).trajectory, i);
    EXPECT_FALSE(rig.task.link.reports.at(i).text.empty());
  }
}

/// The numbers in a text, as it shows them.
std::vector<std::string> numbers_in(std::string_view text) {
  const std::regex number("-?[0-9]+(\\.[0-9]+)?(e[-+]?[0-9]+)?");
  const std::string whole(text);
  std::vector<std::string> found;
  for (std::sregex_iterator match(whole.begin(), whole.end(), number), end; match != end; ++match)
    found.push_back(match->str());
  return found;
}

TEST(External, NumbersOfARefusalDiffer) {
  for (const double beyond : {1e-8, 3e-7, 2e-4, 0.5, 100.0}) {
    Rig rig(20);
    const AxisParameters& axis = rig.robot->parameters().axes[1];
    const double allowance = position_tolerance(axis.position_min, axis.position_max);
    rig.before = [&](int step) {
      if (step != 2) return;
      JointTrajectory trajectory(rig.axes(), Order::positions, 1);
      JointVector to = rig.joints();
      to[1] = axis.position_max + allowance + beyond;
      trajectory.set_point(0, 100, {to.data(), static_cast<std::size_t>(to.size())});
      rig.task.link.send(1, trajectory);
    };
    rig.run();
    const TrajectoryReport& report = rig.task.link.reports.at(1);  // after the one that the robot is yielded
    ASSERT_EQ(report.state, TrajectoryState::refused);
    const std::vector<std::string> numbers = numbers_in(report.text.view());
    ASSERT_GE(numbers.size(), 3u);
    EXPECT_NE(numbers.back(), *(numbers.end() - 3)) << report.text.view();
  }
}

TEST(External, JudgesTolerancesByTheMeasuredJoints) {
  for (const bool goal : {false, true}) {
    Rig rig(900);
    const std::vector<double> some(6, 0.01), none(6, 0.0);
    rig.before = [&](int step) {
      RobotState& state = rig.robot->exchanged_state();
      if (step == 0) {
        JointTrajectory trajectory = blend(rig.joints(), JointVector::Constant(6, 0.1), 2, Order::velocities);
        trajectory.set_tolerances(goal ? none : some, goal ? some : none, goal ? 0.5 : 0);
        rig.task.link.send(1, trajectory);
      }
      if (step > 60) state.joints[2] += 0.011;
    };
    rig.run();
    const TrajectoryState end = goal ? TrajectoryState::goal_tolerance : TrajectoryState::path_tolerance;
    EXPECT_EQ(rig.task.link.states(),
              (std::vector{TrajectoryState::yielded, TrajectoryState::begun, end, TrajectoryState::withdrawn}));
    EXPECT_TRUE(rig.ends.back().at_rest());
    EXPECT_NE(std::string{rig.task.link.reports.at(2).text.view()}.find("0.01"), std::string::npos);
  }
}

TEST(External, WhatIsUnderWayAtTheEndIsTakenBack) {
  Rig rig(50);
  rig.task.link.send(9, blend(JointVector::Zero(6), JointVector::Constant(6, 0.1), 2, Order::velocities));
  rig.before = [&](int step) {
    if (step == 5) rig.task.link.send(10, blend(rig.joints(), JointVector::Constant(6, 0.1), 4, Order::velocities));
  };
  rig.run();
  EXPECT_EQ(rig.task.link.states(),
            (std::vector{TrajectoryState::refused, TrajectoryState::yielded, TrajectoryState::begun,
                         TrajectoryState::taken_back, TrajectoryState::withdrawn}));
}

}  // namespace
}  // namespace mrroc::fakes::external_test
