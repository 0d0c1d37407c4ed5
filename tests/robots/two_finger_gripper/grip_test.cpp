// The gripper with its EDP core in the simulated world.
#include <gtest/gtest.h>

#include <array>

#include "gripper_fixture.hpp"
#include "mrroc/testing/scratch_folder.hpp"
#include "robots/common/simulated_edp.hpp"

namespace mrroc::grip_test {
namespace {

/// A cube of 57 mm, 3 mm off the centre, on a table that a motor can lower.
constexpr const char* kScene = R"(<mujoco><compiler angle="radian"/>
<option cone="elliptic" impratio="10"/>
<worldbody>
  <body name="table" pos="0 0 -0.1585">
    <joint name="lift" type="slide" axis="0 0 1" damping="100"/>
    <geom name="table" type="box" size="0.1 0.1 0.005" mass="1"/>
  </body>
  <body name="cube" pos="0.003 0 -0.125"><freejoint/><geom name="cube" type="box" size="0.0285 0.0285 0.0285" mass="0.2"/></body>
</worldbody>
<actuator><position name="lift" joint="lift" kp="10000"/></actuator>
</mujoco>)";

class GripperGrips : public testing::Test {
 protected:
  GripperGrips() {
    simulation_.publish_initial();
    edp_.start();
  }
  config::Deployment deployment() {
    config::Deployment deployment;
    deployment.sim.emplace();
    deployment.sim->scene = scratch_.write("scene.xml", kScene);
    config::RobotEntry robot;
    robot.name = "gripper";
    robot.type = "two_finger_gripper";
    robot.driver.world = true;
    robot.base.linear() = Eigen::Vector3d(1, -1, -1).asDiagonal();  // fingers down
    deployment.robots.push_back(robot);
    return deployment;
  }
  void run(int ticks) {
    for (int i = 0; i < ticks; ++i) {
      simulation_.step(++now_);
      edp_.tick(now_);
      const mjtNum* q = world().data().qpos + world().model().jnt_qposadr[joint("gripper/centring")];
      worst_asymmetry_ = std::max(worst_asymmetry_, std::abs(q[0] - q[1] / 2));
    }
  }
  sim::World& world() { return simulation_.world(); }
  int joint(const char* name) { return mj_name2id(&world().model(), mjOBJ_JOINT, name); }
  Eigen::Vector3d cube() {
    return Eigen::Map<Eigen::Vector3d>(world().data().xpos + 3 * mj_name2id(&world().model(), mjOBJ_BODY, "cube"));
  }
  /// Force of one pad on the cube, N, of the last physics step, so the cube must be at rest.
  double press_of(const char* pad) {
    const int id = mj_name2id(&world().model(), mjOBJ_GEOM, pad);
    double force = 0;
    for (int i = 0; i < world().data().ncon; ++i) {
      const mjContact& contact = world().data().contact[i];
      if (contact.geom1 != id && contact.geom2 != id) continue;
      std::array<mjtNum, 6> wrench{};
      mj_contactForce(&world().model(), &world().data(), i, wrench.data());
      force += wrench[0];
    }
    return force;
  }
  void lower_table() {
    world().data().ctrl[mj_name2id(&world().model(), mjOBJ_ACTUATOR, "lift")] = -0.1;
    run(500);
  }
  void close_on_the_cube() {
    edp_.go(0.055, 4500);
    run(5000);
  }

  task_test::ScratchFolder scratch_;
  std::unique_ptr<world::WorldMemory> memory_ = std::make_unique<world::WorldMemory>();
  sim::Simulation simulation_{deployment(), *memory_};
  SimulatedEdp edp_{gripper_model(), *memory_, 0};
  Tick now_ = 0;
  double worst_asymmetry_ = 0;
};

TEST_F(GripperGrips, BothFingersStartAtHomeAndStayThere) {
  run(200);
  const mjtNum* q = world().data().qpos + world().model().jnt_qposadr[joint("gripper/centring")];
  EXPECT_NEAR(q[0], gripper_model()->parameters().home[0] / 2, 1e-5);
  EXPECT_NEAR(q[1], gripper_model()->parameters().home[0], 1e-5);
  EXPECT_LT(worst_asymmetry_, 1e-6);
}

TEST_F(GripperGrips, FreeFingersFollowSymmetrically) {
  edp_.go(0.088, 2000);
  double worst = 0;
  for (int i = 0; i < 2500; ++i) {
    run(1);
    worst = std::max(worst, std::abs(edp_.snapshot().desired.position[0] - edp_.snapshot().joints[0]));
  }
  std::printf("worst error %.3f mm, asymmetry %.4f mm\n", 1000 * worst, 1000 * worst_asymmetry_);
  EXPECT_LT(worst, 1e-4) << "far below the threshold of Gripped";
  EXPECT_LT(worst_asymmetry_, 2e-5);
  EXPECT_NEAR(edp_.snapshot().joints[0], 0.088, 2e-6);
}

TEST_F(GripperGrips, CentresTheCubeAndPressesWithTheDrivesForce) {
  close_on_the_cube();
  EXPECT_NEAR(cube().x(), 0, 2e-4);
  EXPECT_EQ(edp_.snapshot().fault.code, ErrorCode::none);
  EXPECT_GT(edp_.snapshot().joints[0] - edp_.snapshot().desired.position[0], 0.001);
  EXPECT_NEAR(edp_.snapshot().joints[0], 0.057, 5e-4) << "the pads are slightly compressed";
  for (const char* pad : {"gripper/pad_left", "gripper/pad_right"}) EXPECT_NEAR(press_of(pad), 186, 5) << pad;
}

TEST_F(GripperGrips, CubeStaysWhenTheTableIsLoweredAndFallsWhenTheGripperOpens) {
  close_on_the_cube();
  const Eigen::Vector3d gripped = cube();
  lower_table();
  EXPECT_LT((cube() - gripped).norm(), 2e-4);
  run(1500);
  EXPECT_LT((cube() - gripped).norm(), 5e-4) << "it slips out";
  edp_.go(0.06, 1000);
  run(1200);
  EXPECT_NEAR(cube().z(), -0.225, 3e-3) << "it lies on the lowered table";
}

TEST_F(GripperGrips, HoldsItsPartWithTheDriveOff) {
  close_on_the_cube();
  edp_.enable(false);
  run(500);
  const Eigen::Vector3d gripped = cube();
  lower_table();
  EXPECT_LT((cube() - gripped).norm(), 2e-4);
}

}  // namespace
}  // namespace mrroc::grip_test
