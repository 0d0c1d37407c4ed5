// JointLine from a present motion: it brakes with the full limits, independent of its own speed.
#include <cmath>

#include "language/joints/joint_line_cell.hpp"
#include "language/joints/joint_targets.hpp"
#include "language/property.hpp"
#include "repetitions.hpp"

namespace mrroc::joint_line::joint_line_braking_test {
namespace {

using fakes::check_property;

TEST(JointLine, ContinuesFromAPresentMotion) {
  check_property(kCases, [] {
    Cell cell;
    const double speed = random_speed();
    set_in_motion(cell, speed);
    const JointVector target = random_target(*cell.arm, cell.axes);
    const double second_speed = std::min(1.0, speed + 0.01 * pick(0, 50));
    Move({*cell.arm}, {}, JointLine(*cell.arm, target, second_speed));
    if (cell.recorder.commands.empty()) return;  // it was already at its target
    assert_ends_at(cell, target);
    assert_within_limits(cell, samples(cell.recorder), 1);  // it may have to brake
  });
}

TEST(JointLine, BrakesAPresentMotionWithTheFullLimitsAtAnySpeed) {
  int slow = 0, fast = 0;
  check_property(kCases, [&] {
    Cell cell;
    set_in_motion(cell, random_speed());
    const JointVector start = cell.arm->state().desired_joints, rest = resting_joints(*cell.arm);
    const JointVector target = random_target(*cell.arm, cell.axes);
    const double speed = std::pow(10, -0.1 * pick(0, 60));
    JointLine line(*cell.arm, target, speed);
    line.until(ElapsedSteps{1000});
    Move({*cell.arm}, {}, line);
    RC_ASSERT(std::isfinite(line.duration()));
    const std::vector<Sample> path = samples(cell.recorder);
    assert_within_limits(cell, path, 1);
    // an axis leaves its path only by its braking distance; within a mrad, because an accelerating axis needs more
    const JointVector low = start.cwiseMin(target).cwiseMin(rest), high = start.cwiseMax(target).cwiseMax(rest);
    const AxisParameters& axis = cell.arm->parameters().axes[0];
    for (const Sample& sample : path) {
      RC_ASSERT((low - sample.position).maxCoeff() < 1e-3);
      RC_ASSERT((sample.position - high).maxCoeff() < 1e-3);
    }
    // a second after the start, every fast axis has been braked
    const double dt = cell.arm->step_duration();
    for (std::size_t k = 0; k < path.size(); ++k)
      if (static_cast<double>(k) * dt > 1)
        RC_ASSERT(path[k].velocity.cwiseAbs().maxCoeff() <= speed * axis.velocity_max + 1e-9);
    ++(speed < 0.01 ? slow : fast);
  });
  EXPECT_GT(slow, test::repetitions(kCases) / 4);
  EXPECT_GT(fast, test::repetitions(kCases) / 8);
}

TEST(JointLine, SlowLineEndsAtItsTarget) {
  check_property(50, [] {
    Cell cell;
    Wait({*cell.arm}, {}, ElapsedSteps{0});
    if (pick(0, 1) == 1) set_in_motion(cell, random_speed());
    JointVector target = cell.arm->state().desired_joints;
    for (Eigen::Index i = 0; i < cell.axes; ++i) target[i] += pick(-10, 10) * std::pow(10, -pick(5, 10));
    JointLine line(*cell.arm, target, std::pow(10, -0.1 * pick(10, 25)));
    const Outcome end = Move({*cell.arm}, {}, line);
    RC_ASSERT(end.ending == Ending::generator);
    if (end.steps > 0) assert_ends_at(cell, target);
  });
}

}  // namespace
}  // namespace mrroc::joint_line::joint_line_braking_test
