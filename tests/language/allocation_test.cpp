// A step of Move or Wait does not allocate after the first one.
#include <gtest/gtest.h>

#include <atomic>

#include "allocations.hpp"
#include "language/fakes.hpp"
#include "mrroc/conditions/elapsed_steps.hpp"
#include "mrroc/conditions/elapsed_time.hpp"
#include "mrroc/conditions/operator_trigger.hpp"
#include "mrroc/conditions/path_travelled.hpp"
#include "mrroc/conditions/position_reached.hpp"
#include "mrroc/conditions/reading_older_than.hpp"
#include "mrroc/conditions/torque_above.hpp"
#include "mrroc/conditions/touching_along.hpp"
#include "mrroc/conditions/travelled.hpp"
#include "mrroc/generators/blended_path.hpp"
#include "mrroc/generators/cartesian_arc.hpp"
#include "mrroc/generators/cartesian_line.hpp"
#include "mrroc/generators/contact_search.hpp"
#include "mrroc/generators/cooperative_motion.hpp"
#include "mrroc/generators/guarded_approach.hpp"
#include "mrroc/generators/guarded_motion.hpp"
#include "mrroc/generators/image_servo.hpp"
#include "mrroc/generators/impedance.hpp"
#include "mrroc/generators/joint_line.hpp"
#include "mrroc/generators/joint_path.hpp"
#include "mrroc/generators/lead_through.hpp"
#include "mrroc/generators/pose_spline.hpp"
#include "mrroc/generators/position_servo.hpp"
#include "mrroc/generators/replay.hpp"
#include "mrroc/generators/spiral_search.hpp"
#include "mrroc/generators/surface_following.hpp"
#include "mrroc/generators/teach_in.hpp"
#include "mrroc/generators/together.hpp"
#include "mrroc/generators/tool_velocity.hpp"
#include "mrroc/generators/track_frame.hpp"
#include "mrroc/generators/weight_measurement.hpp"
#include "mrroc/move.hpp"

namespace mrroc::allocation_test {
namespace {

using fakes::FakeTask;

/// Counts the allocations from one step to the next.
class AllocationObserver : public StepObserver {
 public:
  void on_step(const StepRecord& record) noexcept override {
    const std::uint64_t now = test::allocations();
    if (steps > 1) total += now - before;
    if (!record.last()) ++steps;
    before = test::allocations();
  }
  std::uint64_t steps = 0;
  std::uint64_t total = 0;  ///< from the second step on

 private:
  std::uint64_t before = 0;
};

/// Three robots, an interactive and a non-interactive sensor, an observer.
struct Cell {
  Cell() {
    task.log.recording = false;
    task.step_observer = &observer;
  }
  FakeTask task;
  AllocationObserver observer;
  std::unique_ptr<Robot> a = task.robot("a"), b = task.robot("b"), c = task.robot("c");
  std::unique_ptr<Sensor> wrist = task.sensor("wrist"), gate = task.sensor("gate", false);
};

TEST(Allocation, CounterCountsAllocations) {
  const std::uint64_t before = test::allocations();
  std::vector<double> numbers(100);
  EXPECT_GT(test::allocations(), before);
  ASSERT_EQ(numbers.size(), 100u);
}

TEST(Allocation, StepOfMoveDoesNotAllocate) {
  Cell cell;
  cell.wrist->set_period(2);
  JointLine first(*cell.a, JointVector::Constant(6, 1.5), 0.5);
  JointLine second(*cell.b, JointVector::Constant(6, -1.5), 0.3);
  ToolVelocity third(*cell.c, {0.01, 0.01, 0}, {0, 0, 0.1});
  Together generator(first, second, third);
  generator.until(Travelled{*cell.a, 100} || (OperatorTrigger{cell.task} && !ElapsedSteps{3}) ||
                  When{"far", [&] { return cell.gate->value(0) > 1e9; }} || ElapsedSteps{200});
  Move({*cell.a, *cell.b, *cell.c}, {*cell.wrist, *cell.gate}, generator);
  EXPECT_EQ(cell.observer.steps, 200u);
  EXPECT_EQ(cell.observer.total, 0u);
}

TEST(Allocation, StepAtAChangingSpeedDoesNotAllocate) {
  Cell cell;
  JointLine first(*cell.a, JointVector::Constant(6, 1.5), 0.5);
  JointLine second(*cell.b, JointVector::Constant(6, -1.5), 0.3);
  Together generator(first, second);
  generator.until(When{"changes the speed", [&, steps = 0]() mutable {
                         cell.task.speed = steps % 50 < 20 ? 1 : 0.3;
                         return ++steps > 400;
                       }});
  Move({*cell.a, *cell.b}, {}, generator);
  EXPECT_GE(cell.observer.steps, 400u);
  EXPECT_EQ(cell.observer.total, 0u);
}

// the black box drops the steps of finished instructions
TEST(Allocation, OverwritingStepsOfOtherInstructionsFreesNothing) {
  Cell cell;
  for (int i = 0; i < 100; ++i) {
    Wait({*cell.a, *cell.b}, {*cell.wrist}, ElapsedSteps{static_cast<std::uint64_t>(i % 3)});
    Wait({*cell.c}, {}, When{"a name that is too long to be kept in a string of its own size", [] { return true; }});
  }
  std::uint64_t begin = 0, end = 0;
  Wait({*cell.a, *cell.b, *cell.c}, {*cell.wrist, *cell.gate}, When{"counts", [&, steps = 0]() mutable {
                                                                      if (steps == 0) begin = test::frees();
                                                                      end = test::frees();
                                                                      return ++steps == 120;
                                                                    }});
  EXPECT_GT(begin, 0u);
  EXPECT_EQ(end, begin);
}

TEST(Allocation, StepOfWaitDoesNotAllocate) {
  Cell cell;
  Wait({*cell.a, *cell.b, *cell.c}, {*cell.wrist, *cell.gate}, Travelled{*cell.a, 1} || ElapsedSteps{200});
  EXPECT_EQ(cell.observer.steps, 200u);
  EXPECT_EQ(cell.observer.total, 0u);
}

TEST(Allocation, GeneratorsComputeTheNextStateWithoutAllocation) {
  Cell cell;
  Wait({*cell.a, *cell.b}, {}, ElapsedSteps{0});
  JointLine line(*cell.a, JointVector::Constant(6, 1.5));
  ToolVelocity velocity(*cell.b, {0.1, 0, 0}, {0, 0.2, 0});
  line.start();
  velocity.start();
  const std::uint64_t before = test::allocations();
  while (!line.terminal_condition()) {
    line.next_state();
    velocity.next_state();
  }
  EXPECT_EQ(test::allocations(), before);
}

TEST(Allocation, SensorGeneratorsComputeTheNextStateWithoutAllocation) {
  Cell cell;
  Wait({*cell.a}, {}, ElapsedSteps{0});
  const Pose aside = cell.a->state().desired_pose * Eigen::Translation3d(0.1, 0.2, 0.3);
  MovingFrame belt;
  belt.twist << 0.1, 0.05, 0, 0, 0, 0.1;
  ImagePoints wanted(2, 4), seen(2, 4);
  wanted << 0.1, -0.1, 0.1, -0.1, 0.1, 0.1, -0.1, -0.1;
  seen = 1.2 * wanted;
  GuardedApproach approach(
      *cell.a, [] { return 1.0; }, {1, 2, 3}, 0.1, 0.5);
  TrackFrame track(*cell.a, [&] { return belt; }, {{aside, 0.1}, {Pose::Identity(), 0.1}}, {.tolerance = 10});
  PositionServo position(
      *cell.a, [&] { return aside; }, PositionServo::In::base, Pose::Identity());
  ImageServo image(
      *cell.a, [&] { return seen; }, wanted, ImageDepths::Constant(1, 4, 0.5));
  // all seen at one place: the equations have rank 2
  ImageServo one_place(
      *cell.a, [&]() -> std::optional<ImagePoints> { return seen.col(0).replicate(1, 3); }, wanted.leftCols(3),
      ImageDepths::Constant(1, 3, 0.5));
  SpiralSearch spiral(*cell.a, ForceLaw{}, 0.001, 0.01, 0.01);
  for (Generator* generator :
       std::initializer_list<Generator*>{&approach, &track, &position, &image, &one_place, &spiral}) {
    generator->start();
    const std::uint64_t before = test::allocations();
    for (int step = 0; step < 300 && !generator->terminal_condition(); ++step) generator->next_state();
    EXPECT_EQ(test::allocations(), before) << generator->name();
  }
  EXPECT_EQ(track.point(), 2u) << "it has planned the path to its second point";
}

TEST(Allocation, PathGeneratorsComputeTheNextStateWithoutAllocation) {
  Cell cell;
  Wait({*cell.a}, {}, ElapsedSteps{0});
  const Pose here = cell.a->state().desired_pose;
  const Pose up = here * Eigen::Translation3d(0, 0, 0.2), aside = here * Eigen::Translation3d(0.1, 0.2, 0.1);
  CartesianLine line(*cell.a, aside);
  CartesianArc arc(*cell.a, up.translation(), aside);
  PoseSpline stops(*cell.a, {up, aside}, SplineKind::linear), spline(*cell.a, {up, aside, here});
  PoseSpline timed(*cell.a, {{up, 2.0}, {aside, 4.0}}, SplineKind::quintic);
  BlendedPath blended(*cell.a, {{up, 0.05}, {aside, 0.0}, {here, 0.0}});
  JointPath joints(*cell.a, {JointVector::Constant(6, 0.5), JointVector::LinSpaced(6, -1, 1)});
  for (Generator* generator :
       std::initializer_list<Generator*>{&line, &arc, &stops, &spline, &timed, &blended, &joints}) {
    generator->start();
    const std::uint64_t before = test::allocations();
    int steps = 0;
    for (; steps < 5000 && !generator->terminal_condition(); ++steps) generator->next_state();
    EXPECT_EQ(test::allocations(), before) << generator->name();
    EXPECT_GT(steps, 50) << generator->name();
    EXPECT_LT(steps, 5000) << generator->name();

    generator->start();
    const std::uint64_t before_pause = test::allocations();
    for (steps = 0; steps < 100; ++steps) {
      const bool brakes = steps != 30 || generator->brake();
      EXPECT_TRUE(brakes) << generator->name();
      generator->next_state();
    }
    EXPECT_EQ(test::allocations(), before_pause) << generator->name() << " comes to rest for a pause";
  }
}

// two robots in one Move, each along its own path, which they rejoin after a pause
TEST(Allocation, PathsOfTwoRobotsContinueAfterAPauseWithoutAllocation) {
  Cell cell;
  cell.task.requests.assign(100, OperatorRequest::none);
  cell.task.requests.insert(cell.task.requests.end(), 3, OperatorRequest::pause);
  const Pose up(Eigen::Translation3d(0, 0, 0.2)), aside(Eigen::Translation3d(0.3, 0.2, 0.1));
  Together both{BlendedPath{*cell.a, {{up, 0.05}, {aside, 0.0}}}, JointPath{*cell.b, {JointVector::Constant(6, 0.5)}}};
  std::uint64_t at_resume = 0, planned = 0;
  struct Counting : Generator {
    Counting(Together& inner_, std::uint64_t& at_, std::uint64_t& planned_)
        : Generator("counting"), inner(&inner_), at(&at_), planned(&planned_) {}
    void start() override { inner->start(); }
    void resume() override {
      *at = test::allocations();
      inner->resume();
      *planned += test::allocations() - *at;
    }
    bool terminal_condition() override { return inner->terminal_condition(); }
    void next_state() override { inner->next_state(); }
    Together* inner;
    std::uint64_t *at, *planned;
  };
  Move({*cell.a, *cell.b}, {}, Counting(both, at_resume, planned));
  EXPECT_GT(planned, 0u) << "it has planned again";
  EXPECT_EQ(cell.observer.total, planned) << "and allocated nothing else";
  EXPECT_TRUE(cell.a->state().desired_pose.isApprox(aside, 1e-12));
  EXPECT_TRUE(cell.b->state().desired_joints.isApprox(JointVector::Constant(6, 0.5), 1e-12));
}

TEST(Allocation, ReadyConditionsDoNotAllocate) {
  Cell cell;
  const Robot& arm = *cell.a;
  Wait({*cell.a}, {*cell.wrist},
       PositionReached{arm, Pose(Eigen::Translation3d(1, 0, 0)), 0.1, 0.1} ||
           JointsReached{arm, JointVector::Constant(6, 1), 0.1} || PathTravelled{arm, 1} || TorqueAbove{arm, 1} ||
           TouchingAlong{arm, {0, 0, 1}, 1} || ReadingOlderThan{*cell.wrist, 10} || ElapsedTime{cell.task, 4});
  EXPECT_EQ(cell.observer.steps, 201u) << "a reply comes before the end of its step of 20 ms";
  EXPECT_EQ(cell.observer.total, 0u);
}

TEST(Allocation, ForceAndTeachingGeneratorsDoNotAllocate) {
  Cell cell;
  Robot& arm = *cell.a;
  const std::vector<JointVector> places{JointVector::Constant(6, 0.1), JointVector::Constant(6, 0.2)};
  TaughtPath way, taught;
  way.timed = true;
  for (int i = 0; i < 20; ++i) way.points.push_back({0.3 * i, JointVector::Constant(6, 0.02 * i), {}});
  TaughtPath stations = way;
  stations.timed = false;
  Impedance impedance(arm, Pose::Identity());
  LeadThrough lead(arm);
  GuardedMotion guarded(arm, {0, 0, 0.01}, 5);
  SurfaceFollowing along(arm, 5, {{0, 0, 0}, {0.1, 0, 0}, {0.1, 0.1, 0}}, 0.05);
  ContactSearch search(arm, {{{0, 0, 0}, {0, 0, 1}, 0.1}, {{1, 0, 0}, {0, 0, 1}, 0.1}});
  WeightMeasurement scale(arm, places, {.speed = 1, .settling = 0.1, .measuring = 0.1});
  Replay timed(arm, way), visited(arm, stations);
  TeachIn teach(arm, taught, 0.02);
  for (Generator* generator : std::initializer_list<Generator*>{&impedance, &lead, &guarded, &along, &search, &scale,
                                                                &timed, &visited, &teach}) {
    cell.observer = {};
    Move({arm}, {}, generator->until(ElapsedSteps{300}));
    EXPECT_GT(cell.observer.steps, 50u) << generator->name();
    EXPECT_EQ(cell.observer.total, 0u) << generator->name();
  }
  EXPECT_GT(visited.point(), 2u) << "it has planned several paths";
  EXPECT_EQ(scale.terminal_condition(), true) << "it has been at both positions";
}

TEST(Allocation, ArmsCarryAnObjectWithoutAllocation) {
  Cell cell;
  Wait({*cell.a, *cell.b, *cell.c}, {}, ElapsedSteps{0});
  const auto felt = [] { return Wrench(Wrench::Constant(0.1)); };
  const Pose here = Pose::Identity(), there(Eigen::Translation3d(0.2, 0, 0));
  CooperativeMotion motion({{cell.a.get(), here, felt}, {cell.b.get(), there, felt}, {cell.c.get(), there, felt}},
                           {here, there, there * Eigen::AngleAxisd(0.5, Eigen::Vector3d::UnitZ())});
  motion.start();
  const std::uint64_t before = test::allocations();
  int steps = 0;
  for (; !motion.terminal_condition() && steps < 10000; ++steps) motion.next_state();
  EXPECT_EQ(test::allocations(), before);
  EXPECT_GT(steps, 100);
  EXPECT_TRUE(motion.terminal_condition());

  motion.start();
  const std::uint64_t before_pause = test::allocations();
  for (steps = 0; steps < 100; ++steps) {
    if (steps == 30) motion.brake();
    motion.next_state();
  }
  EXPECT_EQ(test::allocations(), before_pause);
}

}  // namespace
}  // namespace mrroc::allocation_test
