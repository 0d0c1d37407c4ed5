#include "cli/robot/type/show_arm.hpp"

#include <limits>
#include <memory>
#include <stdexcept>

#include "cli/robot/type/arm_report.hpp"
#include "cli/robot/type/type_files.hpp"
#include "cli/robot/urdf_arm.hpp"
#include "config/deployment.hpp"
#include "sim/rendering/camera.hpp"
#include "sim/simulation.hpp"
#include "world/world_memory.hpp"

namespace mrroc::cli {

namespace {

constexpr int kWidth = 960, kHeight = 720;  // pixels

bool is_urdf(const std::string& arm) { return arm.find_first_of("./") != std::string::npos; }

/// The model of an arm in a URDF: its limits are those of the file.
kinematics::ChainModel model_of(const UrdfArm& arm) {
  RobotParameters parameters;
  for (const edp::Urdf::Joint& joint : arm.axes) {
    AxisParameters axis;
    axis.name = joint.name;
    axis.position_min = joint.lower.value_or(-std::numeric_limits<double>::infinity());
    axis.position_max = joint.upper.value_or(std::numeric_limits<double>::infinity());
    if (!(axis.position_max > axis.position_min)) axis.position_max = axis.position_min + 1e-9;
    axis.motor_min = axis.position_min;
    axis.motor_max = axis.position_max;
    const bool known = joint.velocity && *joint.velocity > 0;
    axis.velocity_max = known ? *joint.velocity : std::numeric_limits<double>::infinity();
    axis.acceleration_max = axis.jerk_max = 0;
    parameters.axes.push_back(axis);
  }
  return {"urdf", parameters, arm.chain, JointVector::Ones(std::ssize(arm.axes))};
}

void draw(const ChainType& type, const std::filesystem::path& picture) {
  const config::Deployment deployment = config::load_deployment(type.scene.parent_path() / "demo.toml");
  const auto memory = std::make_unique<world::WorldMemory>();
  const sim::WorldState state = sim::Simulation(deployment, *memory).state();
  const auto model = sim::load_model(sim::compose(deployment));
  sim::Renderer renderer(*model, kWidth, kHeight);
  sim::write_png(picture, renderer.render(state.positions, "main"));
}

}  // namespace

std::string show_arm(const ShowRequest& request) {
  if (is_urdf(request.arm)) {
    if (!request.picture.empty())
      throw std::invalid_argument("--picture: of a URDF, expected the name of a robot type");
    const edp::Urdf urdf = edp::Urdf::load(request.arm, edp::Urdf::Limits::optional);
    const UrdfArm arm = arm_of(urdf, request.base, request.tip);
    return report_of(model_of(arm), arm.base, arm.tip, request.postures);
  }
  const ChainType type = load_chain_type(request.arm);
  std::string text = report_of(*type.model, type.base, type.tip, request.postures);
  if (request.picture.empty()) return text;
  draw(type, request.picture);
  return text + "picture: " + request.picture.string() + "\n";
}

}  // namespace mrroc::cli
