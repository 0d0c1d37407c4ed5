// A target on a limit is reached; an impossible path is refused before any motion. On every robot, checked by its EDP's
// planner.
#include "language/limits.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>

#include "edp/every_robot.hpp"
#include "generators/planned_cell.hpp"
#include "mrroc/generators/blended_path.hpp"
#include "mrroc/generators/cartesian_arc.hpp"
#include "mrroc/generators/cartesian_line.hpp"
#include "mrroc/generators/joint_line.hpp"
#include "mrroc/generators/joint_path.hpp"
#include "mrroc/generators/pose_spline.hpp"
#include "mrroc/generators/replay.hpp"
#include "mrroc/move.hpp"

namespace mrroc::test::limits_test {
namespace {

constexpr int kTries = 3000;
constexpr double kClearance = 40;  // rad of a motor, per path from home: stops leave the line

struct Cell : PlannedCell {
  explicit Cell(const std::shared_ptr<const RobotModel>& its_model, std::uint64_t seed)
      : PlannedCell(its_model), model(its_model), random(seed), arm(*this, "", {its_model}) {
    on_tick = [this](const DesiredState& now, const DesiredState&, const RobotCommand&) {
      ++ticks;
      JointVector motors;
      ASSERT_EQ(model->joints_to_motors(now.position, motors), ErrorCode::none);
      for (std::size_t i = 0; i < axes().size(); ++i) {
        const AxisParameters& axis = axes()[i];
        const auto row = static_cast<Eigen::Index>(i);
        ASSERT_TRUE(is_within(now.position[row], axis.position_min, axis.position_max)) << axis.name;
        ASSERT_TRUE(is_within(motors[row], axis.motor_min, axis.motor_max)) << axis.name;
      }
    };
  }
  /// False: refused, without any motion.
  template <class Make>
  bool move(Make make) {
    ticks = 0;
    try {
      auto generator = make();
      Move({arm}, {}, generator);
      return true;
    } catch (const NonFatalError& error) {
      EXPECT_EQ(ticks, 0) << error.what();
      last = error.what();
      return false;
    }
  }
  bool line(const JointVector& target, double speed) {
    return move([&] { return JointLine{arm, target, speed}; });
  }
  double real(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random); }
  double inside(const AxisParameters& axis, double part) {
    const double low = std::isfinite(axis.position_min) ? axis.position_min : -3;
    const double high = std::isfinite(axis.position_max) ? axis.position_max : 3;
    return low + part * (high - low);
  }
  bool motors_within(const JointVector& joints, JointVector& motors) const {
    if (model->joints_to_motors(joints, motors) != ErrorCode::none) return false;
    for (std::size_t i = 0; i < axes().size(); ++i)
      if (!is_within(motors[static_cast<Eigen::Index>(i)], axes()[i].motor_min, axes()[i].motor_max)) return false;
    return true;
  }
  bool joints_within(const JointVector& joints) const {
    for (std::size_t i = 0; i < axes().size(); ++i)
      if (!is_within(joints[static_cast<Eigen::Index>(i)], axes()[i].position_min, axes()[i].position_max))
        return false;
    return true;
  }
  /// A posture with joint `k` at `value`: home, or a random one that the motors reach.
  bool find_joint_posture(std::size_t k, double value, JointVector& joints) {
    JointVector motors;
    joints = model->parameters().home;
    for (int i = 0; i < kTries; ++i) {
      joints[static_cast<Eigen::Index>(k)] = value;
      if (motors_within(joints, motors)) return true;
      for (std::size_t a = 0; a < axes().size(); ++a)
        joints[static_cast<Eigen::Index>(a)] = inside(axes()[a], real(0.05, 0.95));
    }
    return false;
  }
  /// A posture with motor `k` at `value`, all joints within their limits.
  bool find_motor_posture(std::size_t k, double value, JointVector& joints) {
    JointVector motors, posture = model->parameters().home;
    for (int i = 0; i < kTries; ++i) {
      if (model->joints_to_motors(posture, motors) == ErrorCode::none) {
        motors[static_cast<Eigen::Index>(k)] = value;
        JointVector back;
        if (model->motors_to_joints(motors, joints) == ErrorCode::none && joints_within(joints) &&
            motors_within(joints, back))
          return true;
      }
      for (std::size_t a = 0; a < axes().size(); ++a)
        posture[static_cast<Eigen::Index>(a)] = inside(axes()[a], real(0.05, 0.95));
    }
    return false;
  }

  /// Whether the motors can follow the straight line in joint space and reach no limit along it, because a stop beside
  /// the line would exceed the limit.
  bool straight_from_home(const JointVector& joints) const {
    JointVector motors;
    for (int i = 0; i <= kTries; ++i) {
      const double left = 1 - static_cast<double>(i) / kTries;
      const JointVector place = joints + left * (desired().position - joints);
      if (!motors_within(place, motors)) return false;
      for (std::size_t a = 0; a < axes().size() && left > 0; ++a) {
        const auto row = static_cast<Eigen::Index>(a);
        const double clearance = std::min(motors[row] - axes()[a].motor_min, axes()[a].motor_max - motors[row]);
        if (clearance < kClearance * left) return false;
      }
    }
    return true;
  }

  std::shared_ptr<const RobotModel> model;
  std::mt19937_64 random;
  Robot arm;
  int ticks = 0;
  std::string last;
};

class EveryRobotsLimits : public ::testing::TestWithParam<KnownRobot> {
 protected:
  std::shared_ptr<const RobotModel> model = GetParam().load(GetParam().file("toml")).front();

  /// Every limit of every joint and motor that some posture reaches: `check(cell, posture)` starts at home.
  template <class Check>
  void for_every_limit(Check check) {
    std::uint64_t seed = 1;
    for (std::size_t k = 0; k < model->parameters().axes.size(); ++k) {
      const AxisParameters& axis = model->parameters().axes[k];
      for (const bool motor : {false, true}) {
        for (const double limit :
             motor ? std::array{axis.motor_min, axis.motor_max} : std::array{axis.position_min, axis.position_max}) {
          if (!std::isfinite(limit)) continue;
          Cell cell(model, ++seed);
          JointVector posture;
          const bool found =
              motor ? cell.find_motor_posture(k, limit, posture) : cell.find_joint_posture(k, limit, posture);
          if (!found || !cell.straight_from_home(posture)) continue;
          SCOPED_TRACE(axis.name + (motor ? ", motor at " : " at ") + std::to_string(limit));
          check(cell, posture);
        }
      }
    }
  }
};

TEST_P(EveryRobotsLimits, AreReachedByJointLinesAtEverySpeed) {
  for_every_limit([&](Cell& cell, const JointVector& posture) {
    for (const double speed : {1.0, 0.31, 0.01, 0.001}) {
      cell.arm.set_macrostep(static_cast<std::uint16_t>(cell.real(1, 40)), 1);
      ASSERT_TRUE(cell.line(posture, speed)) << "speed " << speed << ": " << cell.last;
      ASSERT_TRUE((cell.desired().position - posture).isZero(0));
      const JointVector home = model->parameters().home;
      const double way = speed > 0.5 ? 1 : speed > 0.05 ? 0.05 : 0.0005;  // a slow path is a short one
      ASSERT_TRUE(cell.line(JointVector(posture + way * (home - posture)), 1)) << cell.last;
    }
  });
}

TEST_P(EveryRobotsLimits, AreReachedByJointPathsAndReplays) {
  for_every_limit([&](Cell& cell, const JointVector& posture) {
    const JointVector home = model->parameters().home;
    const auto end = [&](bool moved) {
      ASSERT_TRUE(moved) << cell.last;
      ASSERT_TRUE((cell.desired().position - posture).isZero(0));
      ASSERT_TRUE(cell.line(home, 1)) << cell.last;
    };
    const JointVector half = 0.5 * (home + posture);
    for (const double speed : {1.0, 0.37}) {
      cell.arm.set_macrostep(static_cast<std::uint16_t>(cell.real(2, 30)), 1);
      end(cell.move([&] { return JointPath{cell.arm, std::vector<JointVector>{posture}, speed}; }));
      end(cell.move([&] { return JointPath{cell.arm, std::vector<JointVector>{half, posture}, speed}; }));
      TaughtPath path;
      path.points = {{0, half, Pose::Identity()}, {4, posture, Pose::Identity()}};
      end(cell.move([&] { return Replay{cell.arm, path, speed}; }));
      path.timed = true;
      end(cell.move([&] { return Replay{cell.arm, path, speed}; }));
    }
  });
}

TEST_P(EveryRobotsLimits, AreReachedByPathsOfTheTool) {
  std::map<std::string, int> arrived, refused;
  for_every_limit([&](Cell& cell, const JointVector& posture) {
    const JointVector start = posture + 0.06 * (model->parameters().home - posture);
    const Pose end = cell.kinematics().direct(posture);
    const Pose via = cell.kinematics().direct(0.5 * (posture + start));
    const PathLimits limits{0.2, 1, 0.5, 2};
    const auto count = [&](const char* name, bool moved) {
      ++(moved ? arrived : refused)[name];
      if (moved) {
        EXPECT_LT((cell.kinematics().direct(cell.desired().position).matrix() - end.matrix()).norm(), 1e-8);
      }
      ASSERT_TRUE(cell.line(start, 1)) << name << ": " << cell.last;
    };
    ASSERT_TRUE(cell.line(start, 1)) << cell.last;
    count("pose", cell.move([&] { return JointLine{cell.arm, end, 0.8}; }));
    if (cell.axes().size() == 5) return;  // five axes can follow a line of the tool only in special cases
    count("line", cell.move([&] { return CartesianLine{cell.arm, end, limits}; }));
    count("spline", cell.move([&] {
      return PoseSpline{cell.arm, std::vector<Pose>{via, end}, SplineKind::cubic, limits};
    }));
    count("blend", cell.move([&] { return BlendedPath{cell.arm, {{via, 0.005}, {end, 0}}, limits}; }));
    count("arc", cell.move([&] { return CartesianArc{cell.arm, via.translation(), end, limits}; }));
  });
  for (const auto& [name, count] : arrived)
    std::printf("%s: %d arrived, %d refused before\n", name.c_str(), count, refused[name]);
}

TEST_P(EveryRobotsLimits, PathsAreRefusedBeforeAnyMotion) {
  Cell cell(model, 7);
  int moved = 0, refused = 0;
  for (int k = 0; k < 60; ++k) {
    std::vector<JointVector> points;
    for (int i = 0; i < 3; ++i) {
      JointVector joints = model->parameters().home;
      const double way = std::min(1.0, cell.real(0, 1.5));  // from home to a random posture, including the limits
      for (std::size_t a = 0; a < cell.axes().size(); ++a) {
        double& joint = joints[static_cast<Eigen::Index>(a)];
        joint += way * (cell.inside(cell.axes()[a], std::clamp(cell.real(-0.2, 1.2), 0.0, 1.0)) - joint);
      }
      points.push_back(joints);
    }
    TaughtPath path;
    for (const JointVector& joints : points)
      path.points.push_back({4.0 * static_cast<double>(path.points.size()), joints, Pose::Identity()});
    path.timed = k % 2 == 0;
    bool done = false;
    if (k % 3 == 0) done = cell.line(points[0], cell.real(0.2, 1));
    if (k % 3 == 1) done = cell.move([&] { return JointPath{cell.arm, points, 1}; });
    if (k % 3 == 2) done = cell.move([&] { return Replay{cell.arm, path, 1}; });
    ++(done ? moved : refused);
  }
  std::printf("%d moved, %d refused before\n", moved, refused);
  EXPECT_GT(moved, 0);
}

INSTANTIATE_TEST_SUITE_P(Robots, EveryRobotsLimits, ::testing::ValuesIn(every_robot()),
                         [](const auto& robot) { return robot.param.stem; });

}  // namespace
}  // namespace mrroc::test::limits_test
