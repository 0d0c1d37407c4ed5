#include "edp/describe.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <random>

#include "mrroc/tool_kinematics.hpp"

namespace mrroc::edp {
namespace {

bool within_motor_limits(const RobotModel& model, const JointVector& joints) {
  JointVector motors;
  if (model.joints_to_motors(joints, motors) != ErrorCode::none) return false;
  const auto& axes = model.parameters().axes;
  for (std::size_t i = 0; i < axes.size(); ++i) {
    const double motor = motors[static_cast<Eigen::Index>(i)];
    if (motor < axes[i].motor_min || motor > axes[i].motor_max) return false;
  }
  return true;
}

void print_workspace(const RobotModel& model, int points, std::uint64_t seed) {
  const ToolKinematics kinematics(model);
  std::mt19937_64 random(seed);
  JointVector joints(model.joint_count());
  for (int found = 0; found < points;) {
    for (Eigen::Index i = 0; i < joints.size(); ++i) {
      const AxisParameters& axis = model.parameters().axes[static_cast<std::size_t>(i)];
      const double low = std::isfinite(axis.position_min) ? axis.position_min : -std::numbers::pi;
      const double high = std::isfinite(axis.position_max) ? axis.position_max : std::numbers::pi;
      joints[i] = std::uniform_real_distribution<double>(low, high)(random);
    }
    if (!within_motor_limits(model, joints)) continue;
    const Eigen::Vector3d p = kinematics.direct(joints).translation();
    std::printf("%.5f %.5f %.5f\n", p.x(), p.y(), p.z());
    ++found;
  }
}

void print_limits(const RobotParameters& parameters) {
  std::printf("| joint | axis | position, rad or m | velocity, 1/s | acceleration | jerk | motor, rad |\n");
  std::printf("|---|---|---|---|---|---|---|\n");
  int joint = 0;
  for (const AxisParameters& axis : parameters.axes) {
    std::printf("| %d | `%s` | %g .. %g | %g | %g | %g | %g .. %g |\n", joint++, axis.name.c_str(), axis.position_min,
                axis.position_max, axis.velocity_max, axis.acceleration_max, axis.jerk_max, axis.motor_min,
                axis.motor_max);
  }
}

}  // namespace

bool describes(std::string_view argument) noexcept { return argument == "limits" || argument == "workspace"; }

int describe(int argc, char** argv, const RobotModels& models) {
  int points = 10'000;
  std::uint64_t seed = 1;
  std::string name{models.front()->name()};
  CLI::App app{"What this EDP knows of its robot"};
  app.require_subcommand(1);
  const CLI::App* limits = app.add_subcommand("limits", "Markdown table of the axes' limits");
  CLI::App* workspace = app.add_subcommand("workspace", "random tool positions within the limits, x y z in m");
  workspace->add_option("--points", points, "how many")->check(CLI::Range(1, 10'000'000));
  workspace->add_option("--seed", seed, "of the random joints");
  workspace->add_option("--model", name, "kinematic model");
  CLI11_PARSE(app, argc, argv);
  if (limits->parsed()) {
    print_limits(models.front()->parameters());
    return 0;
  }
  for (const auto& model : models) {
    if (model->name() != name) continue;
    print_workspace(*model, points, seed);
    return 0;
  }
  std::fprintf(stderr, "no model '%s' of %s\n", name.c_str(), models.front()->parameters().type.c_str());
  return 2;
}

}  // namespace mrroc::edp
