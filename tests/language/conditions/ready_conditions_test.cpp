// The conditions of include/mrroc/conditions on time, positions, forces, and the age of readings.
#include <limits>

#include "language/free_flyer.hpp"
#include "language/property.hpp"
#include "language/random_values.hpp"
#include "mrroc/conditions/elapsed_steps.hpp"
#include "mrroc/conditions/elapsed_time.hpp"
#include "mrroc/conditions/path_travelled.hpp"
#include "mrroc/conditions/position_reached.hpp"
#include "mrroc/conditions/reading_older_than.hpp"
#include "mrroc/conditions/torque_above.hpp"
#include "mrroc/conditions/touching_along.hpp"
#include "mrroc/conditions/travelled.hpp"
#include "mrroc/move.hpp"

namespace mrroc::ready_conditions_test {
namespace {

using Eigen::Vector3d;
using fakes::check_property;
using fakes::FakeTask;
using fakes::FreeFlyer;
using fakes::pick;
using fakes::random_vector;

constexpr int kCases = 500;
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Of length 1.
Vector3d random_direction() { return (random_vector(1) + Vector3d(0, 0, 2.5)).normalized(); }

Pose random_pose() {
  Pose pose = Pose::Identity();
  pose.translation() = random_vector(1);
  pose.linear() = exp_rotation(random_vector(2));
  return pose;
}

/// Makes the fake's state the arm's state.
void check(FreeFlyer& task) {
  task.arm->reset_command(CommandKind::query);
  task.arm->send();
  task.arm->receive();
}

/// Values beside the tolerance, where rounding does not decide.
double beside(double tolerance) { return tolerance * (pick(0, 1) == 0 ? 0.01 * pick(0, 99) : 0.01 * pick(101, 300)); }

TEST(PositionReached, HoldsWithinTheTolerances) {
  check_property(kCases, [] {
    const Pose wanted = random_pose();
    const double tolerance = 0.001 * pick(1, 50), angle = 0.01 * pick(1, 90);
    const double off = beside(tolerance), turned_by = beside(angle);
    FreeFlyer task(Pose::Identity());
    task.state.pose = wanted;
    task.state.pose.translation() += off * random_direction();
    task.state.pose.linear() = wanted.linear() * exp_rotation(turned_by * random_direction());
    check(task);
    PositionReached place(*task.arm, Vector3d{wanted.translation()}, tolerance);
    PositionReached pose(*task.arm, wanted, tolerance, angle);
    RC_ASSERT(place.evaluate() == (off < tolerance));
    RC_ASSERT(pose.evaluate() == (off < tolerance && turned_by < angle));
  });
}

TEST(JointsReached, HoldsWhenEveryJointIsAtItsTarget) {
  check_property(kCases, [] {
    FreeFlyer task(Pose::Identity());
    const double tolerance = 0.01 * pick(1, 50);
    JointVector wanted(6), now(6);
    bool there = true;
    for (int i = 0; i < 6; ++i) {
      const double off = pick(0, 5) == 0 ? beside(tolerance) : 0;
      wanted[i] = 0.1 * pick(-20, 20);
      now[i] = wanted[i] + (pick(0, 1) == 0 ? off : -off);
      there = there && off < tolerance;
    }
    task.state.joints = now;
    check(task);
    RC_ASSERT((JointsReached{*task.arm, wanted, tolerance}.evaluate()) == there);
  });
}

TEST(PathTravelled, CountsThePathAlsoWhenItReturns) {
  check_property(kCases, [] {
    FreeFlyer task(random_pose());
    check(task);
    const double length = 0.01 * pick(1, 300) + 0.0005;
    PathTravelled path(*task.arm, length);
    path.start();
    double way = 0;
    for (int step = 0; step < 20; ++step) {
      RC_ASSERT(path.evaluate() == (way >= length));
      const double stride = 0.001 * pick(0, 200);
      way += stride;
      if (std::abs(way - length) < 1e-9) return;
      task.state.pose.translation() += (step % 2 == 0 ? 1 : -1) * stride * random_direction();
      check(task);
    }
  });
}

TEST(PathTravelled, EndsACircleWhichTravelledDoesNot) {
  FreeFlyer task(Pose::Identity());
  check(task);
  PathTravelled path(*task.arm, 0.6);
  Travelled straight(*task.arm, 0.21);
  path.start();
  straight.start();
  int steps = 0;
  for (; !path.evaluate() && steps < 1000; ++steps) {
    const double angle = 0.01 * steps;
    task.state.pose.translation() = 0.1 * Vector3d(std::cos(angle) - 1, std::sin(angle), 0);
    EXPECT_FALSE(straight.evaluate());
    check(task);
  }
  EXPECT_NEAR(steps, 601, 1) << "0.6 m on a radius of 0.1 m";
}

TEST(ElapsedTime, EndsAtTheFirstStepAfterTheTime) {
  check_property(kCases, [] {
    FakeTask task;
    const auto arm = task.robot("arm");
    const auto n = static_cast<std::uint16_t>(pick(1, 30));
    arm->set_macrostep(n, n);
    const int ticks = pick(0, 500);
    ElapsedTime condition(task, ticks * task.servo_period());
    const Outcome end = Wait({*arm}, {}, condition);
    RC_ASSERT(end.steps == static_cast<std::uint64_t>((ticks + n - 1) / n));
    RC_ASSERT(end.by<ElapsedTime>());
    RC_ASSERT(Wait({*arm}, {}, condition).steps == end.steps);  // it starts again
  });
}

TEST(ReadingOlderThan, HoldsWithoutAReadingAndWithAnOldOne) {
  FakeTask task;
  const auto arm = task.robot("arm");
  task.add_sensor("camera");
  task.sensor_fake("camera").is_polled = true;
  const auto camera = task.sensor("camera");
  task.sensor_fake("camera").late = 3;
  const Outcome first = Wait({*arm}, {*camera}, !ReadingOlderThan{*camera, 1});
  EXPECT_EQ(first.steps, 3u) << "no reading yet, which counts as infinitely old";
  task.sensor_fake("camera").late = 1000;
  const Outcome lost = Wait({*arm}, {*camera}, ReadingOlderThan{*camera, 0.1} || ElapsedSteps{100});
  EXPECT_TRUE(lost.by<ReadingOlderThan>());
  EXPECT_GT(camera->age(), 0.1);
  EXPECT_LT(camera->age(), 0.1 + 2 * arm->step_duration());
}

/// Its one channel is the torque about x.
class Spindle : public Sensor {
 public:
  explicit Spindle(Task& task) : Sensor(task, "spindle", "fake") {}
  Vector3d torque() const noexcept { return {value(0), 0, 0}; }
};

TEST(TorqueAbove, UsesTheTorqueOfASensorOrOfTheRobot) {
  FakeTask task;
  task.add_sensor("spindle", true, -3.5);  // -3.5, -2.5, ... 5.5
  Spindle spindle(task);
  EXPECT_EQ(Wait({}, {spindle}, TorqueAbove{spindle, 4}).steps, 8u);
  EXPECT_FALSE((TorqueAbove{spindle, 100}.evaluate()));

  check_property(kCases, [] {
    FreeFlyer flyer(Pose::Identity());
    const double limit = 0.01 * pick(1, 500), torque = beside(limit);
    flyer.state.wrench << random_vector(100), torque * random_direction();
    check(flyer);
    RC_ASSERT((TorqueAbove{*flyer.arm, limit}.evaluate()) == (torque > limit));
  });
}

TEST(TouchingAlong, HoldsWhenTheToolPressesInThatDirection) {
  check_property(kCases, [] {
    FreeFlyer task(Pose::Identity());
    const Vector3d direction = random_direction(), aside = direction.unitOrthogonal();
    const double limit = 0.1 * pick(1, 200), force = beside(limit), sideways = pick(-50, 50);
    task.state.wrench.head<3>() = -force * direction + sideways * aside;
    check(task);
    RC_ASSERT((TouchingAlong{*task.arm, 0.01 * pick(1, 900) * direction, limit}.evaluate()) == (force > limit));
    RC_ASSERT(!(TouchingAlong{*task.arm, -direction, limit}.evaluate()));
  });
}

TEST(ReadyConditions, HaveNamesAndCombine) {
  FakeTask task;
  const auto arm = task.robot("arm");
  const auto gate = task.sensor("gate");
  EXPECT_EQ((ElapsedTime{task, 2.5}.name()), "elapsed 2.5 s");
  EXPECT_EQ((PositionReached{*arm, Vector3d{0, 0, 1}, 0.002}.name()), "arm within 0.002 m of its place");
  EXPECT_EQ((JointsReached{*arm, JointVector::Zero(6), 0.1}.name()), "arm joints within 0.1");
  EXPECT_EQ((PathTravelled{*arm, 1}.name()), "a way of 1 m");
  EXPECT_EQ((ReadingOlderThan{*gate, 0.05}.name()), "gate reading older than 0.05 s");
  EXPECT_EQ((TorqueAbove{*arm, 0.5}.name()), "arm torque above 0.5 N m");
  EXPECT_EQ((TouchingAlong{*arm, {0, 0, 1}, 5}.name()), "arm presses with 5 N");
  const Outcome end =
      Wait({*arm}, {*gate},
           (PositionReached{*arm, Vector3d{0, 0, 1}, 0.002} && JointsReached{*arm, JointVector::Zero(6), 0.1}) ||
               ((TorqueAbove{*arm, 0.5} || TouchingAlong{*arm, {0, 0, 1}, 5}) && !PathTravelled{*arm, 1}) ||
               (ReadingOlderThan{*gate, 0.05} || named("time is up", ElapsedTime{task, 0.2})));
  EXPECT_EQ(end.reason(), "time is up");
}

TEST(ReadyConditions, RefuseInvalidArguments) {
  FakeTask task;
  const auto arm = task.robot("arm");
  const auto gate = task.sensor("gate");
  const Vector3d place = Vector3d::Zero();
  for (const double bad : {-1.0, kNan, kInfinity}) {
    EXPECT_THROW((ElapsedTime{task, bad}), NonFatalError);
    EXPECT_THROW((ReadingOlderThan{*gate, bad}), NonFatalError);
    EXPECT_THROW((TorqueAbove{*arm, bad}), NonFatalError);
  }
  for (const double bad : {0.0, -1.0, kNan, kInfinity}) {
    EXPECT_THROW((PositionReached{*arm, place, bad}), NonFatalError);
    EXPECT_THROW((PositionReached{*arm, Pose::Identity(), 0.1, bad}), NonFatalError);
    EXPECT_THROW((JointsReached{*arm, JointVector::Zero(6), bad}), NonFatalError);
    EXPECT_THROW((PathTravelled{*arm, bad}), NonFatalError);
    EXPECT_THROW((TouchingAlong{*arm, {0, 0, 1}, bad}), NonFatalError);
  }
  EXPECT_THROW((PositionReached{*arm, Vector3d{0, kNan, 0}, 0.1}), NonFatalError);
  Pose sheared = Pose::Identity();
  sheared.linear()(0, 1) = 0.1;
  EXPECT_THROW((PositionReached{*arm, sheared, 0.1, 0.1}), NonFatalError);
  EXPECT_THROW((JointsReached{*arm, JointVector::Zero(5), 0.1}), NonFatalError);
  EXPECT_THROW((JointsReached{*arm, JointVector::Constant(6, kNan), 0.1}), NonFatalError);
  EXPECT_THROW((TouchingAlong{*arm, place, 1}), NonFatalError);
  EXPECT_THROW((TouchingAlong{*arm, {0, kNan, 0}, 1}), NonFatalError);
}

}  // namespace
}  // namespace mrroc::ready_conditions_test
