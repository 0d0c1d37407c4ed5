#include <cmath>
#include <limits>
#include <set>

#include "language/free_flyer.hpp"
#include "language/property.hpp"
#include "language/random_values.hpp"
#include "mrroc/conditions/elapsed_steps.hpp"
#include "mrroc/generators/image_servo.hpp"
#include "mrroc/generators/position_servo.hpp"
#include "mrroc/move.hpp"

namespace mrroc::visual_servo_test {
namespace {

using Eigen::Vector3d;
using fakes::check_property;
using fakes::FreeFlyer;
using fakes::pick;
using fakes::random_vector;

constexpr int kCases = 100;
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr std::uint64_t kMostSteps = 20000;

/// A pose of at most `largest` m per axis and sqrt(3) * `turn` rad.
Pose random_pose(double largest, double turn) {
  Pose pose = Pose::Identity();
  pose.translation() = random_vector(largest);
  pose.linear() = exp_rotation(random_vector(turn));
  return pose;
}

/// A macrostep is at most 40 ms: the limit with a camera.
std::uint16_t random_steps() { return static_cast<std::uint16_t>(pick(4, 20)); }

/// A square of points around a target's origin in the image of a pinhole camera.
struct Square {
  double half = 0.08;
  ImagePoints seen_from(const Pose& target_in_camera) const {
    ImagePoints points(2, 4);
    for (int i = 0; i < 4; ++i) {
      const Vector3d p = target_in_camera * Vector3d(i % 2 == 0 ? half : -half, i < 2 ? half : -half, 0);
      points.col(i) << p.x() / p.z(), p.y() / p.z();
    }
    return points;
  }
};

/// A tool with a camera before a target, and the goals of both servos.
struct Cell {
  /// `away`, `turn`: distance of the start from the goal.
  Cell(double away, double turn)
      : camera(random_pose(0.1, 0.5)),
        target(random_pose(0.5, 1)),
        wanted_in_camera(Eigen::Translation3d(0.02, -0.03, 0.5) * Pose(exp_rotation(random_vector(0.2)))),
        goal(target * (camera * wanted_in_camera).inverse()),
        task(goal * camera * random_pose(away, turn) * camera.inverse(), random_steps()) {}
  Pose target_in_camera() const { return (task.arm->state().pose * camera).inverse() * target; }
  bool is_lost() { return lost.contains(looks++); }
  PositionServo position(PositionServo::In in = PositionServo::In::camera) {
    return {*task.arm,
            [this, in]() -> std::optional<Pose> {
              if (is_lost()) return std::nullopt;
              return in == PositionServo::In::base ? target : target_in_camera();
            },
            in,
            camera* wanted_in_camera,
            camera,
            limits};
  }
  ImageServo image(double depth_error = 1) {
    return {*task.arm,
            [this]() -> std::optional<ImagePoints> {
              if (is_lost()) return std::nullopt;
              return square.seen_from(target_in_camera());
            },
            square.seen_from(wanted_in_camera),
            ImageDepths::Constant(1, 4, 0.5 * depth_error),
            camera,
            limits,
            5e-4};
  }
  template <class Servo>
  Outcome run(Servo&& servo) {
    return Move({*task.arm}, {}, servo.until(ElapsedSteps{kMostSteps}));
  }
  double distance() const { return (task.arm->state().desired_pose.translation() - goal.translation()).norm(); }
  double angle() const {
    return rotation_vector(goal.linear().transpose() * task.arm->state().desired_pose.linear()).norm();
  }
  /// Speed, angular speed and their rates, per tool axis, of the commands.
  void check_limits() const {
    Twist before = Twist::Zero();
    for (const RobotCommand& command : task.commands) {
      const Twist now = rotate_twist(command.pose.linear().transpose(), command.twist);
      RC_ASSERT(now.head<3>().norm() <= 1.02 * limits.speed);
      RC_ASSERT(now.tail<3>().norm() <= 1.02 * limits.angular_speed);
      RC_ASSERT((now - before).cwiseAbs().maxCoeff() <= limits.acceleration * task.arm->step_duration() + 1e-9);
      before = now;
    }
    RC_ASSERT(before.isZero(0));
  }

  Pose camera, target, wanted_in_camera, goal;
  FreeFlyer task;
  Square square;
  ServoLimits limits;
  std::set<int> lost;  ///< numbers of the queries at which the target is not visible
  int looks = 0;
};

TEST(PositionServo, ConvergesFromAnyStartWithinItsLimits) {
  check_property(kCases, [] {
    Cell cell(0.5, 1.5);
    cell.limits.gain = 0.1 * pick(5, 20);
    cell.task.delayed = pick(0, 1) == 1;
    const auto in = pick(0, 1) == 1 ? PositionServo::In::base : PositionServo::In::camera;
    RC_ASSERT(cell.run(cell.position(in)).ending == Ending::generator);
    // the measured state is a macrostep old; it moves on by less than the tolerance
    RC_ASSERT(cell.distance() <= 1.1e-3);
    RC_ASSERT(cell.angle() <= 5.5e-3);
    cell.check_limits();
  });
}

TEST(PositionServo, NeverMovesAwayFromTheGoal) {
  check_property(kCases, [] {
    Cell cell(0.3, 0.5);
    double before = (cell.task.state.desired_pose.translation() - cell.goal.translation()).norm();
    cell.run(cell.position());
    for (const RobotCommand& command : cell.task.commands) {
      const double now = (command.pose.translation() - cell.goal.translation()).norm();
      RC_ASSERT(now <= before + 2e-4);
      before = now;
    }
  });
}

TEST(PositionServo, CommandsNothingAtTheGoal) {
  check_property(20, [] {
    Cell cell(0, 0);
    RC_ASSERT(cell.run(cell.position()).steps == 0u);
  });
}

TEST(ImageServo, InteractionMatrixIsTheImagesDerivative) {
  check_property(kCases, [] {
    const Vector3d p = Vector3d(0, 0, 1) + random_vector(0.5);
    Twist twist;
    twist << random_vector(0.5), random_vector(1);
    const auto image = [&](double t) {
      const Vector3d seen = exp_twist(t * twist).inverse() * p;
      return Eigen::Vector2d(seen.x() / seen.z(), seen.y() / seen.z());
    };
    const double h = 1e-5;
    const Eigen::Vector2d derivative = (image(h) - image(-h)) / (2 * h);
    const Eigen::Vector2d s = image(0);
    RC_ASSERT((point_interaction(s.x(), s.y(), p.z()) * twist - derivative).norm() < 1e-6);
  });
}

TEST(ImageServo, ConvergesFromRandomStartsWithWrongDepthsWithinItsLimits) {
  check_property(kCases, [] {
    Cell cell(0.1, 0.2);
    cell.limits.gain = 0.1 * pick(5, 15);
    cell.task.delayed = pick(0, 1) == 1;
    RC_ASSERT(cell.run(cell.image(0.01 * pick(70, 140))).ending == Ending::generator);
    RC_ASSERT(cell.distance() <= 5e-3);
    RC_ASSERT(cell.angle() <= 1e-2);
    cell.check_limits();
  });
}

// the closed loop de/dt = -lambda e of the law, after the ramp at the start: correct depths, small errors
TEST(ImageServo, ErrorDecaysAtTheGain) {
  check_property(100, [] {
    Cell cell(0.01, 0.02);
    cell.limits = {.gain = 0.5, .speed = 10, .angular_speed = 10, .acceleration = 10, .patience = 0};
    cell.task.arm->set_macrostep(2, 2);
    const auto error = [&] {
      return (cell.square.seen_from(cell.target_in_camera()) - cell.square.seen_from(cell.wanted_in_camera)).norm();
    };
    ImageServo servo = cell.image();
    Move({*cell.task.arm}, {}, servo.until(ElapsedSteps{100}));
    const double first = error();
    if (first < 4e-3) return;  // it might be within the tolerance before the end
    ImageServo same = cell.image();
    Move({*cell.task.arm}, {}, same.until(ElapsedSteps{100}));
    RC_ASSERT(std::abs(std::log(first / error()) / (0.5 * 0.4) - 1) < 0.1);
  });
}

template <class Make>
void check_losing_the_target(const Make& make) {
  check_property(100, [&] {
    Cell cell(0.1, 0.2);
    const int from = pick(1, 60), length = pick(1, cell.limits.patience);
    for (int i = 0; i < length; ++i) cell.lost.insert(from + i);
    RC_ASSERT(cell.run(make(cell)).ending == Ending::generator);
    RC_ASSERT(cell.distance() <= 5e-3);
    cell.check_limits();
    // the ramp to rest: first the present acceleration is removed, then the opposite one is built up
    const double most = 0.2 + cell.limits.angular_speed / cell.limits.acceleration + 0.2;
    const auto at_rest = static_cast<std::size_t>(from + std::ceil(most / cell.task.arm->step_duration()));
    if (at_rest < static_cast<std::size_t>(from + length)) RC_ASSERT(cell.task.commands[at_rest].twist.norm() < 1e-9);
  });
  check_property(50, [&] {
    Cell cell(0.1, 0.2);
    cell.limits.patience = pick(0, 60);
    const int from = pick(0, 30);
    for (int i = 0; i <= cell.limits.patience; ++i) cell.lost.insert(from + i);
    try {
      cell.run(make(cell));
      RC_ASSERT(cell.looks <= from + cell.limits.patience);  // the target was visible before
    } catch (const NonFatalError& error) {
      RC_ASSERT(error.code() == ErrorCode::sensor_not_ready);
      // after the error the robot is only held until it rests
      const auto moves = static_cast<std::size_t>(from + cell.limits.patience);
      RC_ASSERT(cell.task.commands.size() >= moves);
      for (std::size_t i = moves; i < cell.task.commands.size(); ++i)
        RC_ASSERT(cell.task.commands[i].kind == CommandKind::hold);
    }
  });
}

TEST(PositionServo, LostTargetStopsItSmoothlyAndItContinuesOrThrows) {
  check_losing_the_target([](Cell& cell) { return cell.position(); });
}

TEST(ImageServo, LostTargetStopsItSmoothlyAndItContinuesOrThrows) {
  check_losing_the_target([](Cell& cell) { return cell.image(); });
}

TEST(PositionServo, RefusesInvalidArguments) {
  FreeFlyer task(Pose::Identity());
  const auto target = [] { return std::optional<Pose>(Pose::Identity()); };
  const Pose good = Pose::Identity();
  Pose bad = good;
  bad.linear() *= 2;
  const auto make = [&](const Pose& wanted, const Pose& camera, const ServoLimits& limits, double tolerance) {
    PositionServo{*task.arm, target, PositionServo::In::camera, wanted, camera, limits, tolerance};
  };
  EXPECT_NO_THROW(make(good, good, {}, 1e-3));
  EXPECT_THROW(make(bad, good, {}, 1e-3), NonFatalError);
  EXPECT_THROW(make(good, bad, {}, 1e-3), NonFatalError);
  EXPECT_THROW(make(good, good, {}, 0), NonFatalError);
  EXPECT_THROW(make(good, good, {.gain = 0}, 1e-3), NonFatalError);
  EXPECT_THROW(make(good, good, {.speed = kNan}, 1e-3), NonFatalError);
  EXPECT_THROW(make(good, good, {.angular_speed = -1}, 1e-3), NonFatalError);
  EXPECT_THROW(make(good, good, {.acceleration = 0}, 1e-3), NonFatalError);
  EXPECT_THROW(make(good, good, {.patience = -1}, 1e-3), NonFatalError);
  EXPECT_THROW((PositionServo{*task.arm, nullptr, PositionServo::In::base, good}), NonFatalError);
}

TEST(ImageServo, RefusesInvalidArguments) {
  FreeFlyer task(Pose::Identity());
  const ImagePoints four = Square{}.seen_from(Pose(Eigen::Translation3d(0, 0, 1)));
  const auto points = [&] { return std::optional<ImagePoints>(four); };
  const ImageDepths depths = ImageDepths::Constant(1, 4, 1.0);
  EXPECT_NO_THROW((ImageServo{*task.arm, points, four, depths}));
  EXPECT_THROW((ImageServo{*task.arm, nullptr, four, depths}), NonFatalError);
  EXPECT_THROW((ImageServo{*task.arm, points, four.leftCols<2>(), depths.leftCols<2>()}), NonFatalError);
  EXPECT_THROW((ImageServo{*task.arm, points, four, depths.leftCols<3>()}), NonFatalError);
  EXPECT_THROW((ImageServo{*task.arm, points, four, -depths}), NonFatalError);
  EXPECT_THROW((ImageServo{*task.arm, points, kNan * four, depths}), NonFatalError);
  EXPECT_THROW((ImageServo{*task.arm, points, four, depths, Pose::Identity(), {}, 0}), NonFatalError);
  ImageServo other(*task.arm, points, four.leftCols<3>(), depths.leftCols<3>());
  EXPECT_THROW(Move({*task.arm}, {}, other), NonFatalError) << "another number of points than wanted";
}

}  // namespace
}  // namespace mrroc::visual_servo_test
