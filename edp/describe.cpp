#include "edp/describe.hpp"

#include <CLI/CLI.hpp>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <random>

#include "command/number_option.hpp"
#include "command/parse_command.hpp"
#include "command/print.hpp"
#include "command/printable.hpp"
#include "edp/check/postures.hpp"
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

int describe_robot(int argc, char** argv, const ModelFactory& factory) {
  int points = 10'000;
  std::uint64_t seed = 1;
  std::string name;
  std::filesystem::path parameters;
  CLI::App app{"Data of this EDP's robot"};
  app.require_subcommand(1);
  CLI::App* limits = app.add_subcommand("limits", "Markdown table of the axes' limits");
  CLI::App* workspace = app.add_subcommand("workspace", "random tool positions within the limits, x y z in m");
  command::add_number(*workspace, "--points", points, 1, 10'000'000, "how many");
  command::add_number<std::uint64_t>(*workspace, "--seed", seed, 0, std::numeric_limits<std::uint64_t>::max(),
                                     "of the random joints");
  workspace->add_option("--model", name, "kinematic model");
  for (CLI::App* each : {limits, workspace})
    each->add_option("--parameters", parameters, "parameter file, in place of the type's own");
  if (const auto exit_code = command::parse_command(app, argc, argv)) return *exit_code;
  const RobotModels models = factory(parameters);
  if (name.empty()) name = models.front()->name();
  if (limits->parsed()) {
    print_limits(models.front()->parameters());
    command::finish_output();
    return 0;
  }
  for (const auto& model : models) {
    if (model->name() != name) continue;
    const bool whole = print_workspace(*model, points, seed);
    command::finish_output();
    return whole ? 0 : 2;
  }
  std::fprintf(stderr, "no model '%s' of %s\n", name.c_str(), models.front()->parameters().type.c_str());
  return 2;
}

}  // namespace

bool describes(std::string_view argument) noexcept { return argument == "limits" || argument == "workspace"; }

int describe(int argc, char** argv, const ModelFactory& factory) try {
  signal(SIGXFSZ, SIG_IGN);  // a file size limit is an error of the write
  return describe_robot(argc, argv, factory);
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", command::printable_lines(error.what()).c_str());
  return 4;
}

}  // namespace mrroc::edp
