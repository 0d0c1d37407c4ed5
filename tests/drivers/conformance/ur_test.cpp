#include <cstdlib>
#include <limits>
#include <optional>

#include "mrroc/testing/driver.hpp"
#include "robots/irb6/irb6_model.hpp"
#include "sim/ur/controller_servers.hpp"

namespace mrroc::driver_test {
namespace {

using sim::ur::ControllerServers;
using sim::ur::Six;
using sim::ur::VirtualController;

constexpr int kForever = 1'000'000'000;  // packages

/// A simulated UR controller on free ports, whose joints are those of an IRb-6.
class UrController final : public StandIn {
 public:
  /// Patient, because the machine may be busy.
  std::string keys() const override {
    std::string text = "address = \"127.0.0.1\"\nmissed_max = 100\nwatchdog = 0.5\ntimeout = 0.5\n";
    text += "script = \"" MRROC_SOURCE_DIR "/drivers/ur/control.script\"\n";
    if (const char* const defect = std::getenv("MRROC_TEST_DEFECT"))  // of the driver bad_clock
      text.append("defect = \"").append(defect).append("\"\n");
    if (!servers_) return text + "rtde_port = 9\ndashboard_port = 9\nscript_port = 9";  // discard: none listens there
    const ControllerServers::Ports& ports = servers_->ports();
    text += "rtde_port = " + std::to_string(ports.rtde) + "\ndashboard_port = " + std::to_string(ports.dashboard);
    return text + "\nscript_port = " + std::to_string(ports.secondary);
  }
  void start(const JointVector& shafts) override {
    ControllerServers::Options options;
    options.rtde_port = options.dashboard_port = options.primary_port = 0;
    options.secondary_port = options.realtime_port = 0;
    options.controller.unlock_delay = 0.2;
    JointVector joints;
    if (model_->motors_to_joints(shafts, joints) != ErrorCode::none) throw std::runtime_error("home is out of reach");
    Six position{};
    for (Eigen::Index i = 0; i < 6; ++i) position[static_cast<std::size_t>(i)] = joints[i];
    servers_.emplace(options, std::make_unique<sim::ur::ExactJoints>(position));
  }
  void stop() override { servers_.reset(); }
  JointVector shafts() override {
    JointVector joints(6), shafts;
    servers_->with([&](VirtualController& controller) {
      const Six position = controller.position();
      for (Eigen::Index i = 0; i < 6; ++i) joints[i] = position[static_cast<std::size_t>(i)];
    });
    if (model_->joints_to_motors(joints, shafts) != ErrorCode::none) shafts = JointVector::Constant(6, 1e9);
    return shafts;
  }
  bool has(Trouble) const override { return true; }
  void set(Trouble trouble, bool on) override {
    if (trouble == Trouble::silence) servers_->lose(on ? kForever : 0);
    if (trouble == Trouble::loss) servers_->lose_every(on ? 5 : 0);
    if (trouble == Trouble::doubling) servers_->repeat(on ? kForever : 0);
    if (trouble == Trouble::lateness) servers_->postpone(on ? 3 : 0);
    if (trouble == Trouble::garbage && on) servers_->send_garbage();
    if (trouble == Trouble::restart && on) servers_->restart();
    servers_->with([&](VirtualController& controller) {
      if (trouble == Trouble::not_finite) controller.falsify(on ? std::numeric_limits<double>::quiet_NaN() : 0);
      if (trouble == Trouble::jump) controller.falsify(on ? 0.1 : 0);
      if (trouble == Trouble::no_power) controller.set_remote_control(!on);
      if (trouble == Trouble::drive_fault && on) controller.protective_stop();
    });
  }

 private:
  std::shared_ptr<const RobotModel> model_ = load_irb6({}).front();
  std::optional<ControllerServers> servers_;
};

}  // namespace
}  // namespace mrroc::driver_test

MRROC_DRIVER_TEST(mrroc::driver_test::UrController, mrroc::load_irb6)
