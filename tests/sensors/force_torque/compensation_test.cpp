// Residual of the weight compensation in MuJoCo: the IRb-6 at rest in random postures without contact.
#include <gtest/gtest.h>

#include <cstdio>
#include <memory>
#include <random>

#include "config/robot_parameters_file.hpp"
#include "robots/irb6/irb6_model.hpp"
#include "sensors/force_torque/made_sensor.hpp"
#include "sim/sensors.hpp"
#include "sim/world.hpp"
#include "sim/worlds.hpp"
#include "text_of.hpp"

namespace mrroc::vsp::compensation_test {
namespace {

constexpr int kPostures = 1000;
constexpr double kForceLimit = 0.3;    // N
constexpr double kTorqueLimit = 0.03;  // N m
constexpr const char* kToolMass = "tool_mass = 1.0\ntool_centre = [0.004, 0.0, 0.066]\n";
constexpr const char* kNoise = "force_noise = 0.05\ntorque_noise = 0.004\n";  // that a good transducer has

/// The robot's own MJCF with a tool of 1 kg in place of 1.1 kg.
std::string with_tool_of_one_kilogram() {
  std::string text = test::text_of(config::robot_file("irb6", "irb6.xml"));
  const std::string mass = "mass=\"1.1\"";
  const std::size_t at = text.find(mass);
  EXPECT_NE(at, std::string::npos) << "the tool has another mass";
  return text.replace(at, mass.size(), "mass=\"1.0\"");
}

class Arm {
 public:
  Arm() : world_(composed(), 0.002, 0.001) {
    std::vector<std::string> names;
    for (const AxisParameters& axis : model_->parameters().axes) names.push_back(axis.name);
    world_.attach("arm", names, model_->parameters().home);
    world_.start();
    hardware_ = std::make_unique<sim::SensorSource>(world_.model(), "wrist", "force_torque", "arm");
  }

  /// Brings the arm to rest at `joints`, with closed brakes. False: it touches itself or the floor.
  bool rest_at(const JointVector& joints) {
    world::JointDrive none;
    none.joint_count = 6;
    world_.drive(0, none, tick_);  // releases the brakes
    std::copy(joints.begin(), joints.end(), world_.data().qpos);
    world_.brake(0);
    for (int i = 0; i < 2; ++i) world_.step(++tick_);
    JointVector now = joints;
    std::copy_n(world_.data().qpos, 6, now.begin());
    EXPECT_EQ(now, joints);
    return world_.data().ncon == 0;
  }

  RawReading wrist() const {
    RawReading slot;
    hardware_->read(world_.data(), slot);
    RawReading r;
    r.tick = tick_;
    r.count = slot.count;
    std::copy_n(slot.values.begin(), slot.count, r.values.begin());
    return r;
  }

  /// e_l at `joints`, from the robot's closed forms, which are independent of MuJoCo.
  RobotState state_at(const JointVector& joints) const {
    RobotState state;
    state.tick = tick_;
    state.synchronised = true;
    state.tool = model_->default_tool();
    state.pose = model_->flange(joints) * state.tool;
    return state;
  }

  const RobotModel& model() const { return *model_; }

 private:
  static sim::Composition composed() {
    const task_test::ScratchFolder scratch;
    const sim::RobotPart arm{"arm", scratch.write("arm.xml", with_tool_of_one_kilogram()), sim::at(0, 0, 0.7), true};
    return sim::compose(
        scratch.write(
            "scene.xml",
            "<mujoco><compiler angle='radian'/><worldbody><geom type='plane' size='4 4 0.1'/></worldbody></mujoco>"),
        {arm});
  }

  std::shared_ptr<const RobotModel> model_ = load_irb6().front();
  sim::World world_;
  std::unique_ptr<sim::SensorSource> hardware_;
  Tick tick_ = 0;
};

/// Maximum and root mean square of the residual norms of force and torque.
struct Residual {
  void add(const Wrench& w) {
    const Eigen::Vector2d norms(w.head<3>().norm(), w.tail<3>().norm());
    worst = worst.cwiseMax(norms);
    least = least.cwiseMin(norms);
    squares += norms.cwiseAbs2();
    ++count;
  }
  Eigen::Vector2d root_mean_square() const { return (squares / count).cwiseSqrt(); }
  void print(const char* what) const {
    const Eigen::Vector2d rms = root_mean_square();
    std::printf("%-34s worst %.3g N, %.3g N m; RMS %.3g N, %.3g N m; over %d postures\n", what, worst[0], worst[1],
                rms[0], rms[1], count);
  }
  Eigen::Vector2d worst = Eigen::Vector2d::Zero(), least = Eigen::Vector2d::Constant(1e9);
  Eigen::Vector2d squares = Eigen::Vector2d::Zero();
  int count = 0;
};

TEST(ForceTorqueCompensation, ResidualOfAKilogramIsBelowItsLimitsInAThousandFreePostures) {
  Arm arm;
  ForceTorqueSensor exact = made_sensor(kToolMass);
  ForceTorqueSensor noisy = made_sensor(std::string(kToolMass) + kNoise);
  ForceTorqueSensor stale = made_sensor(kToolMass);  // as if the pose were missing
  ForceTorqueSensor without = made_sensor();
  stale.effector_state(arm.state_at(arm.model().parameters().home));
  Residual of_exact, of_noisy, of_stale, of_without;
  std::mt19937_64 random(1);
  int tried = 0;
  while (of_exact.count < kPostures && ++tried < 20 * kPostures) {
    JointVector joints(6);
    for (int i = 0; i < 6; ++i) {
      const AxisParameters& axis = arm.model().parameters().axes[static_cast<std::size_t>(i)];
      joints[i] = std::uniform_real_distribution<double>(axis.position_min, axis.position_max)(random);
    }
    if (!arm.rest_at(joints)) continue;
    const RawReading r = arm.wrist();
    for (ForceTorqueSensor* sensor : {&exact, &noisy}) sensor->effector_state(arm.state_at(joints));
    of_exact.add(wrench_of(aggregated(exact, r)));
    of_noisy.add(wrench_of(aggregated(noisy, r)));
    of_stale.add(wrench_of(aggregated(stale, r)));
    of_without.add(wrench_of(aggregated(without, r)));
  }
  of_exact.print("compensated:");
  of_noisy.print("compensated, noise 0.05 N, 4 mN m:");
  of_stale.print("compensated with the pose of home:");
  of_without.print("without compensation:");
  ASSERT_EQ(of_exact.count, kPostures);
  for (const Residual& residual : {of_exact, of_noisy}) {
    EXPECT_LT(residual.worst[0], kForceLimit);
    EXPECT_LT(residual.worst[1], kTorqueLimit);
  }
  EXPECT_GT(of_without.least[0], 5) << "the weight acts in every posture";
  EXPECT_GT(of_stale.root_mean_square()[0], 5) << "and the postures differ";
}

}  // namespace
}  // namespace mrroc::vsp::compensation_test
