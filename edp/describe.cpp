#include "edp/describe.hpp"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <random>

#include "edp/postures.hpp"
#include "mrroc/tool_kinematics.hpp"

namespace mrroc::edp {
namespace {

constexpr int kTriesPerPoint = 1000;

/// False: hardly any posture is within the motors' limits.
bool print_workspace(const RobotModel& model, int points, std::uint64_t seed) {
  const ToolKinematics kinematics(model);
  std::mt19937_64 random(seed);
  int found = 0;
  for (std::int64_t tries = 0; found < points && tries < std::int64_t{points} * kTriesPerPoint; ++tries) {
    const JointVector joints = random_joints(model, random);
    if (!within_motor_limits(model, joints)) continue;
    const Eigen::Vector3d p = kinematics.direct(joints).translation();
    std::printf("%.5f %.5f %.5f\n", p.x(), p.y(), p.z());
    ++found;
  }
  if (found == points) return true;
  std::fprintf(stderr, "only %d of %d random postures within the motors' limits\n", found, points);
  return false;
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
    return print_workspace(*model, points, seed) ? 0 : 2;
  }
  std::fprintf(stderr, "no model '%s' of %s\n", name.c_str(), models.front()->parameters().type.c_str());
  return 2;
}

}  // namespace mrroc::edp
