#include "mrroc/testing/driver.hpp"
#include "mrroc/testing/scratch_folder.hpp"
#include "robots/irb6/irb6_model.hpp"
#include "sim/simulation.hpp"

namespace mrroc::driver_test {
namespace {

/// The simulated world, stepped by the test, with an IRb-6 in slot 0.
class World final : public StandIn {
 public:
  void start(const JointVector& shafts) override {
    config::Deployment deployment;
    deployment.sim.emplace();
    deployment.sim->scene = scratch_.write("scene.xml", R"(<mujoco><compiler angle="radian"/></mujoco>)");
    config::RobotEntry robot;
    robot.name = "robot";
    robot.type = "irb6";
    robot.driver.world = true;
    robot.base.translation().z() = 1;
    deployment.robots.push_back(robot);
    simulation_.reset();
    memory_ = std::make_unique<world::WorldMemory>();
    simulation_ = std::make_unique<sim::Simulation>(deployment, *memory_);
    simulation_->publish_initial();
    shafts_ = shafts;
    silent_ = false;
    last_ = 0;
  }
  void stop() override { simulation_.reset(); }
  bool can_be_absent() const override { return false; }
  void advance(Tick tick) override {
    while (!silent_ && simulation_ != nullptr && last_ < tick) simulation_->step(++last_);
  }
  JointVector shafts() override {
    world::JointMeasurement measurement;
    if (!memory_->measurements[0].load(measurement)) return shafts_;
    const JointVector joints = Eigen::Map<const Eigen::VectorXd>(measurement.position.data(), model_->joint_count());
    if (model_->joints_to_motors(joints, shafts_) != ErrorCode::none) shafts_.setConstant(1e9);
    return shafts_;
  }
  bool has(Trouble trouble) const override { return trouble == Trouble::silence; }
  void set(Trouble, bool on) override { silent_ = on; }
  world::WorldMemory* world() override { return memory_.get(); }
  bool simulated_time() const override { return true; }

 private:
  task_test::ScratchFolder scratch_;
  std::shared_ptr<const RobotModel> model_ = load_irb6({}).front();
  std::unique_ptr<world::WorldMemory> memory_ = std::make_unique<world::WorldMemory>();
  std::unique_ptr<sim::Simulation> simulation_;
  JointVector shafts_;
  bool silent_ = false;
  Tick last_ = 0;
};

}  // namespace
}  // namespace mrroc::driver_test

MRROC_DRIVER_TEST(mrroc::driver_test::World, mrroc::load_irb6)
