#include "cli/commands/robot_command.hpp"

#include <filesystem>
#include <memory>
#include <string>

#include "cli/robot/arm_report.hpp"
#include "command/number_option.hpp"
#include "command/print.hpp"
#include "command/printable.hpp"

namespace mrroc::cli {

namespace {

struct ShownArm {
  std::filesystem::path file;
  std::string base, tip;
  int postures = 2000;
};

}  // namespace

void add_robot_command(CLI::App& app, int& exit_code) {
  CLI::App* const robot = app.add_subcommand("robot", "Look at the description of an arm");
  robot->require_subcommand(1);
  CLI::App* const show = robot->add_subcommand("show", "Show the axes, the inverse and the reach of an arm in a URDF");
  auto arm = std::make_shared<ShownArm>();
  show->add_option("FILE", arm->file, "URDF")->required();
  show->add_option("--base", arm->base, "Link at the beginning of the arm; default: the root");
  show->add_option("--tip", arm->tip, "Link at its end; default: the end of most axes");
  command::add_number(*show, "--postures", arm->postures, 1, 1000000, "random postures of the check");
  show->callback([arm, &exit_code] {
    const edp::Urdf urdf = edp::Urdf::load(arm->file);
    command::print(command::printable_lines(report_of(arm_of(urdf, arm->base, arm->tip), arm->postures)));
    exit_code = 0;
  });
}

}  // namespace mrroc::cli
