// The generators of force motions on an IRb-6 with its EDP core and wrist sensor in the simulated world.
#include <cmath>

#include "generators/force_cell.hpp"
#include "geometry/rigid_motion.hpp"
#include "mrroc/conditions/elapsed_steps.hpp"
#include "mrroc/conditions/travelled.hpp"
#include "mrroc/generators/contact_search.hpp"
#include "mrroc/generators/guarded_motion.hpp"
#include "mrroc/generators/hold.hpp"
#include "mrroc/generators/impedance.hpp"
#include "mrroc/generators/joint_line.hpp"
#include "mrroc/generators/lead_through.hpp"
#include "mrroc/generators/surface_following.hpp"
#include "mrroc/generators/weight_measurement.hpp"
#include "mrroc/move.hpp"

namespace mrroc::test::force_motions_test {
namespace {

using Eigen::Vector3d;

/// A stylus on the arm's tool, a ball of 8 mm radius with its centre 0.34 m from the flange, and `more` bodies.
std::string scene(const std::string& more) {
  return R"(<mujoco><compiler angle="radian"/><option timestep="0.001" cone="elliptic"/>
<worldbody>
  <body name="stylus" pos="0.75 0 0.61" quat="0 1 0 0"><freejoint/>
    <geom type="sphere" size="0.008" mass="0.2" solref="0.003 1" friction="0.2 0.005 0.0001"/>
    <geom type="capsule" size="0.004" fromto="0 0 -0.01 0 0 -0.09" mass="0.1" contype="0" conaffinity="0"/>
  </body>)" +
         more + R"(
</worldbody>
<equality><weld body1="arm/tool" body2="stylus" relpose="0 0 0.25 1 0 0 0" solref="0.002 1" solimp="0.99 0.999 0.0001"/></equality>
<contact><exclude body1="arm/tool" body2="stylus"/></contact>
</mujoco>)";
}

constexpr double kRadius = 0.008;  // m, of the stylus

/// The arm with the stylus as its tool; the sensor is zeroed at rest.
struct Stylus : ForceCell {
  explicit Stylus(const std::string& more)
      : ForceCell(scene(more), "tool_mass = 1.4\ntool_centre = [0.003143, 0.0, 0.101857]\n") {
    arm.set_tool(Pose(Eigen::Translation3d(0, 0, 0.34)));
    Move({arm}, {}, Hold{arm, 0.5});
    arm.bias_force();
  }
  void go_to(double x, double y, double z) {
    Move({arm}, {}, JointLine{arm, Irb6::tool_down(x, y, z)});
    Move({arm}, {}, Hold{arm, 0.5});
    arm.bias_force();
  }
  Pose tip() const { return tool() * Eigen::Translation3d(0, 0, 0.34 - 0.25); }
  Irb6 arm{*this};
};

/// A block on springs of `stiffness` (N/m); 0: fixed. Its level top is at `height` in the arm's base frame.
std::string block(double height, double stiffness) {
  const std::string spring = "<joint type='slide' axis='0 0 1' stiffness='" + std::to_string(stiffness) +
                             "' damping='" + std::to_string(0.02 * stiffness) + "'/>";
  return "<body name='block' pos='0.75 0 " + std::to_string(0.7 + height - 0.02) + "'>" +
         (stiffness > 0 ? spring : "") +
         "<geom type='box' size='0.1 0.1 0.02' mass='0.2' friction='0.2 0.005 0.0001' solref='0.003 1'/></body>";
}

TEST(WeightMeasurementInSimulation, FindsMassAndCentreOfTheLoad) {
  // 1.5 kg, the centre 30 mm beside and 80 mm beyond the tool's tip
  const std::string load = R"(<mujoco><compiler angle="radian"/>
<worldbody><body name="load" pos="0.78 -0.02 0.62" quat="0 1 0 0"><freejoint/>
  <geom type="box" size="0.03 0.02 0.04" mass="1.5" contype="0" conaffinity="0"/></body></worldbody>
<equality><weld body1="arm/tool" body2="load" relpose="0.03 0.02 0.24 1 0 0 0" solref="0.002 1" solimp="0.99 0.999 0.0001"/></equality>
</mujoco>)";
  for (const std::string& keys :
       {std::string(ForceCell::kToolTakenOut),
        std::string(ForceCell::kToolTakenOut) + "force_noise = 0.1\ntorque_noise = 0.005\n"}) {
    const bool noisy = keys.find("noise") != std::string::npos;
    ForceCell cell(load, keys);
    Irb6 arm(cell);
    JointVector posture = arm.parameters().home;
    std::vector<JointVector> postures{posture};
    for (const Vector3d& turn : {Vector3d(0.8, 0, 0), Vector3d(0, -1.2, 0), Vector3d(-0.4, 0.6, 1)}) {
      posture.tail<3>() = arm.parameters().home.tail<3>() + turn;
      postures.push_back(posture);
    }
    WeightMeasurement scale(arm, postures);
    Move({arm}, {}, scale);
    const LoadEstimate found = scale.estimate();
    std::printf("%s: %.4f kg +- %.4f, centre (%.2f, %.2f, %.2f) mm +- %.2f, left %.3f N, %.4f N m, spread %.2f\n",
                noisy ? "with noise" : "without noise", found.load.mass, found.mass_deviation,
                1000 * found.load.centre.x(), 1000 * found.load.centre.y(), 1000 * found.load.centre.z(),
                1000 * found.centre_deviation, found.force_residual, found.torque_residual, found.spread);
    EXPECT_NEAR(found.load.mass, 1.5, 0.01);
    EXPECT_LT((found.load.centre - Vector3d(0.03, 0.02, 0.08)).norm(), 1e-3);
    EXPECT_NEAR(found.load.mass, 1.5, 4 * found.mass_deviation + 1e-3);
  }
}

TEST(GuardedMotionInSimulation, StopsAtAContact) {
  for (const double stiffness : {2e3, 2e4, 0.0}) {
    Stylus cell(block(-0.12, stiffness));
    cell.go_to(0.75, 0, -0.09);
    double most = 0;
    cell.on_tick = [&] { most = std::max(most, std::abs(cell.force()[2])); };
    const double speed = stiffness > 0 ? 0.02 : 0.008;  // hard objects are approached more slowly
    GuardedMotion motion(cell.arm, {0, 0, speed}, 5);
    const Outcome end = Move({cell.arm}, {}, motion.until(Travelled{cell.arm, 0.05}));
    cell.run(100);
    std::printf(
        "block on springs of %.0f kN/m (0: fixed) at %.0f mm/s: touched at %.2f mm below its top, at most %.1f N\n",
        stiffness / 1000, 1000 * speed,
        1000 * (-0.12 + kRadius - motion.touched().value_or(Pose::Identity()).translation().z()), most);
    EXPECT_EQ(end.ending, Ending::generator);
    ASSERT_TRUE(motion.touched().has_value());
    EXPECT_NEAR(motion.touched()->translation().z(), -0.12 + kRadius, 0.0005 + (stiffness > 0 ? 6 / stiffness : 0));
    EXPECT_LT(most, 40);
  }
}

TEST(LeadThroughInSimulation, ToolFollowsAHandAndStaysWhereItIsReleased) {
  Stylus cell("");
  const int tool = cell.id(mjOBJ_BODY, "arm/tool");
  const Vector3d home = cell.tip().translation();
  // a hand that holds the tip by a spring, and moves along a slanted circle
  bool holds = true;
  Vector3d hand = home;
  double farthest = 0, t = 0;
  cell.on_tick = [&] {
    mjtNum* const wrench = cell.data().xfrc_applied + 6 * tool;  // at the body's centre of mass, world axes
    mju_zero(wrench, 6);
    if (!holds) return;
    t += SimulatedCell::kPeriod;
    const double angle = std::min(t, 12.0) * 0.5236;
    hand = home + 0.08 * Vector3d(std::sin(angle), std::cos(angle) - 1, 0.5 * std::sin(angle));
    const Vector3d tip = cell.tip().translation();
    const Vector3d force = 400 * (hand - tip);
    const Vector3d centre = Eigen::Map<Vector3d>(cell.data().xipos + 3 * tool) - Vector3d(0, 0, 0.7);
    const Vector3d torque = (tip - centre).cross(force);
    for (int i = 0; i < 3; ++i) wrench[i] = force[i], wrench[3 + i] = torque[i];
    if (t > 1) farthest = std::max(farthest, (hand - tip).norm());
  };
  Guidance guidance;
  guidance.damping = 100;
  Move({cell.arm}, {}, LeadThrough{cell.arm, guidance}.until(ElapsedSteps{650}));
  const Vector3d led = cell.tip().translation();
  holds = false;
  Move({cell.arm}, {}, LeadThrough{cell.arm, guidance}.until(ElapsedSteps{50}));
  const Vector3d left = cell.tip().translation();
  Move({cell.arm}, {}, LeadThrough{cell.arm, guidance}.until(ElapsedSteps{200}));
  std::printf(
      "hand on a spring of 400 N/m at 42 mm/s: the tool at most %.1f mm behind, creeps %.3f mm in 4 s when released\n",
      1000 * farthest, 1000 * (cell.tip().translation() - left).norm());
  EXPECT_LT(farthest, 0.03);
  EXPECT_LT((led - hand).norm(), 0.012) << "the spring holds at most the threshold";
  EXPECT_LT((cell.tip().translation() - left).norm(), 1e-3);
}

TEST(SurfaceFollowingInSimulation, TurnsTheToolAlongADome) {
  // a ball of 0.4 m radius on springs, its top 0.12 m below the base frame
  Stylus cell(R"(<body pos="0.75 0 0.18"><joint type="slide" axis="0 0 1" stiffness="3000" damping="60"/>
    <geom type="sphere" size="0.4" mass="0.3" friction="0.2 0.005 0.0001" solref="0.01 1"/></body>)");
  cell.go_to(0.72, -0.06, -0.10);
  const Vector3d centre(0.75, 0, -0.52);
  const auto lean = [&] {
    const Pose tip = cell.tip();
    return std::acos(-tip.linear().col(2).dot((tip.translation() - centre).normalized()));
  };
  SurfaceContact contact;
  contact.turn_to_normal = true;
  const double before = lean();
  Move({cell.arm}, {}, SurfaceFollowing{cell.arm, 8, {0.02, -0.03, 0}, contact}.until(Travelled{cell.arm, 0.04}));
  double worst_lean = 0, force_square = 0, force_worst = 0;
  int ticks = 0;
  cell.on_tick = [&] {
    worst_lean = std::max(worst_lean, lean());
    const double off = cell.force()[2] + 8;
    force_square += off * off;
    force_worst = std::max(force_worst, std::abs(off));
    ++ticks;
  };
  const Vector3d start = cell.tip().translation();
  Move({cell.arm}, {}, SurfaceFollowing{cell.arm, 8, {0.02, -0.03, 0}, contact}.until(Travelled{cell.arm, 0.1}));
  std::printf(
      "dome of 0.4 m at 36 mm/s over %.0f mm: z axis off the normal by %.1f deg at first, at most %.1f after; force 8 "
      "N, error %.2f N RMS, %.2f at most\n",
      1000 * (cell.tip().translation() - start).norm(), before * 57.3, worst_lean * 57.3,
      std::sqrt(force_square / ticks), force_worst);
  EXPECT_GT(before, 0.1);
  // the header's lag, and what the arm adds
  EXPECT_LT(worst_lean, 1.3 * 0.036 / 0.4 * (1 / contact.turning_gain + SurfaceFollowing::kSmoothing) + 0.01);
  EXPECT_LT(std::sqrt(force_square / ticks), 1.0);
}

TEST(SurfaceFollowingInSimulation, FollowsAPathAcrossASlope) {
  Stylus cell(
      R"(<body pos="0.75 0 0.55" euler="0.1 -0.08 0"><joint type="slide" axis="0 0 1" stiffness="3000" damping="60"/>
    <geom type="box" size="0.15 0.15 0.02" mass="0.3" friction="0.2 0.005 0.0001" solref="0.01 1"/></body>)");
  cell.go_to(0.72, -0.04, -0.10);
  const std::vector<Vector3d> path{
      {0.72, -0.04, 0}, {0.79, -0.04, 0}, {0.79, 0.04, 0}, {0.72, 0.04, 0}, {0.72, -0.04, 0}};
  SurfaceFollowing follow(cell.arm, 8, path, 0.03);
  double farthest = 0;
  cell.on_tick = [&] {
    if (follow.way() < 0.01) return;
    const Eigen::Vector2d p = cell.tip().translation().head<2>();
    double nearest = 1;
    for (std::size_t i = 1; i < path.size(); ++i) {
      const Eigen::Vector2d a = path[i - 1].head<2>(), leg = path[i].head<2>() - a;
      const double u = std::clamp((p - a).dot(leg) / leg.squaredNorm(), 0.0, 1.0);
      nearest = std::min(nearest, (p - a - u * leg).norm());
    }
    farthest = std::max(farthest, nearest);
  };
  const Outcome end = Move({cell.arm}, {}, follow.until(ElapsedSteps{2000}));
  std::printf("path of %.0f mm with four corners across a slope: at most %.2f mm beside it, %.1f s\n",
              1000 * follow.length(), 1000 * farthest, end.duration);
  EXPECT_EQ(end.ending, Ending::generator);
  EXPECT_LT(farthest, 0.004);
}

TEST(ContactSearchInSimulation, TouchesASlopeAtAGrid) {
  Stylus cell(
      R"(<body pos="0.75 0 0.55" euler="0.1 -0.08 0"><geom type="box" size="0.15 0.15 0.02" solref="0.005 1"/></body>)");
  cell.go_to(0.72, -0.03, -0.09);
  const Pose frame = Irb6::tool_down(0.72, -0.03, -0.10);
  ContactSearch search(cell.arm, grid_of_probes(frame, 3, 3, 0.03, 0.06), {.speed = 0.01});
  double most = 0;
  cell.on_tick = [&] { most = std::max(most, cell.force().head<3>().norm()); };
  const Outcome end = Move({cell.arm}, {}, search.until(ElapsedSteps{20000}));
  EXPECT_EQ(end.ending, Ending::generator);
  ASSERT_EQ(search.count(), 9);
  // distance of the positions from the plane of the ball's centre in contact
  const Eigen::Matrix3d slope =
      (Eigen::AngleAxisd(0.1, Vector3d::UnitX()) * Eigen::AngleAxisd(-0.08, Vector3d::UnitY())).toRotationMatrix();
  const Vector3d normal = slope.col(2), top = Vector3d(0.75, 0, -0.15) + (0.02 + kRadius) * normal;
  double sum = 0, square = 0;
  for (const auto& place : search.touched()) {
    const double off = (*place - top).dot(normal);
    sum += off / 9;
    square += off * off / 9;
  }
  const double scatter = std::sqrt(std::max(0.0, square - sum * sum));
  std::printf("nine touches of a hard slope: on average %.3f mm off, scatter %.4f mm, at most %.1f N, %.1f s\n",
              1000 * sum, 1000 * scatter, most, end.duration);
  EXPECT_LT(std::abs(sum), 3e-4);
  EXPECT_LT(scatter, 1e-4);
  EXPECT_LT(most, 30);
}

TEST(ImpedanceInSimulation, DeflectsByForceOverStiffnessAndReturns) {
  Stylus cell("");
  const int tool = cell.id(mjOBJ_BODY, "arm/tool");
  Vector3d push = Vector3d::Zero();
  cell.on_tick = [&] {
    mjtNum* const wrench = cell.data().xfrc_applied + 6 * tool;
    const Vector3d centre = Eigen::Map<Vector3d>(cell.data().xipos + 3 * tool) - Vector3d(0, 0, 0.7);
    const Vector3d torque = (cell.tip().translation() - centre).cross(push);  // as if it pushed at the tip
    for (int i = 0; i < 3; ++i) wrench[i] = push[i], wrench[3 + i] = torque[i];
  };
  const Pose home = cell.arm.state().desired_pose;
  ImpedanceParameters parameters;
  parameters.stiffness.head<3>() << 400, 800, 1200;  // tool axes: x as the base, y and z opposite
  for (const Vector3d& force : {Vector3d(15, 0, 0), Vector3d(0, 15, 0), Vector3d(0, 0, -15)}) {
    push = force;
    Move({cell.arm}, {}, Impedance{cell.arm, home, parameters}.until(ElapsedSteps{150}));
    const Vector3d moved = cell.tip().translation() - home.translation();
    const Vector3d expected =
        (home.linear() * (home.linear().transpose() * force).cwiseQuotient(parameters.stiffness.head<3>()));
    std::printf("pushed with (%.0f, %.0f, %.0f) N it deflects by (%.2f, %.2f, %.2f) mm, expected (%.2f, %.2f, %.2f)\n",
                force.x(), force.y(), force.z(), 1000 * moved.x(), 1000 * moved.y(), 1000 * moved.z(),
                1000 * expected.x(), 1000 * expected.y(), 1000 * expected.z());
    EXPECT_LT((moved - expected).norm(), 0.03 * expected.norm() + 3e-4);
    push.setZero();
    Move({cell.arm}, {}, Impedance{cell.arm, home, parameters}.until(ElapsedSteps{200}));
    EXPECT_LT((cell.tip().translation() - home.translation()).norm(), 6e-4);
  }
}

}  // namespace
}  // namespace mrroc::test::force_motions_test
