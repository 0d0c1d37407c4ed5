// Paths at the operator's speed, checked by the IRb-6's own planner: within all limits at every tick, on the same path.
#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>

#include "generators/path_cell.hpp"
#include "mrroc/generators/blended_path.hpp"
#include "mrroc/generators/cartesian_arc.hpp"
#include "mrroc/generators/cartesian_line.hpp"
#include "mrroc/generators/joint_line.hpp"
#include "mrroc/generators/joint_path.hpp"
#include "mrroc/generators/pose_spline.hpp"

namespace mrroc::test {
namespace {

using fakes::pick;

TEST(Speed, Experiment) {
  const int cases = std::getenv("CASES") ? std::atoi(std::getenv("CASES")) : 300;
  int refused = 0, moved = 0;
  double worst_jerk = 0, worst_acc = 0, worst_v = 0;
  const double fixed = std::getenv("FIXED") ? std::atof(std::getenv("FIXED")) : 0;
  rc::check("x", [&] {
    for (int i = 0; i < cases / 100; ++i) {
      PathCell cell;
      if (std::getenv("N")) cell.arm.set_macrostep(static_cast<std::uint16_t>(std::atoi(std::getenv("N"))), 2);
      const Pose target = cell.random_pose();
      std::unique_ptr<Generator> generator;
      const int kind = pick(0, 3);
      JointVector joints = cell.axes_home();
      for (Eigen::Index a = 0; a < joints.size(); ++a) joints[a] += 0.01 * pick(-40, 40);
      try {
      if (kind == 0) generator = std::make_unique<CartesianLine>(cell.arm, target, PathLimits{0.3, 1, 1, 4});
      if (kind == 1) generator = std::make_unique<JointLine>(cell.arm, joints, 1.0);
      if (kind == 2) generator = std::make_unique<JointPath>(cell.arm, std::vector<JointVector>{joints, cell.axes_home()}, 1.0);
      if (kind == 3) generator = std::make_unique<BlendedPath>(cell.arm, std::vector<BlendPoint>{{cell.random_pose(), 0.01}, {target, 0}}, PathLimits{0.3, 1, 1, 4});
      } catch (const NonFatalError&) { continue; }
      const double speed = fixed != 0 ? fixed : 0.01 * pick(1, 100);
      const Tick at = 1000 + static_cast<Tick>(pick(0, 1500));
      const double second = 0.01 * pick(1, 100);
      const Tick again = at + static_cast<Tick>(pick(0, 800));
      cell.speed_at = [=](Tick now) { return fixed != 0 ? fixed : now < at ? 1.0 : now < again ? speed : second; };
      try {
        Move({cell.arm}, {}, *generator);
        ++moved;
      } catch (const NonFatalError& error) {
        if (cell.ticks > 0) {
          ++refused;
          std::printf("kind %d N %d s %g at %d %g at %d: tick %d %s\n", kind, int(cell.arm.motion_steps()), speed, int(at), second, int(again), cell.ticks, error.what());
        }
      }
      worst_jerk = std::max(worst_jerk, cell.worst.jerk);
      worst_acc = std::max(worst_acc, cell.worst.acceleration);
      worst_v = std::max(worst_v, cell.worst.velocity);
    }
  });
  std::printf("moved %d refused %d worst jerk %g acc %g v %g\n", moved, refused, worst_jerk, worst_acc, worst_v);
}

}  // namespace
}  // namespace mrroc::test
