#include "cli/robot/robot_verbs.hpp"

#include <memory>

#include "command/number_option.hpp"

namespace mrroc::cli {

namespace {

void add_add(CLI::App& robot, const RobotActions& actions) {
  CLI::App* const add = robot.add_subcommand("add", "Make a robot type of an arm in a URDF");
  auto request = std::make_shared<AddRequest>();
  add->add_option("FILE", request->urdf, "URDF")->required();
  add->add_option("--name", request->name, "Name of the type; default: the robot's name in the URDF");
  add->add_option("--base", request->base, "Link at the beginning of the arm; default: the root");
  add->add_option("--tip", request->tip, "Link at its end; default: the end of most axes");
  add->add_option("--limits", request->limits, "TOML file with limits that the URDF lacks, or that replace its own");
  add->add_flag("--accept-guesses", request->accept_guesses, "Guess the limits that are in no file");
  add->add_option("--drives", request->drives, "What follows set-points: the arm itself, or its torques")
      ->check(CLI::IsMember({"itself", "torque"}))
      ->capture_default_str();
  add->add_option("--into", request->into, "Folder of robot types; default: the user's");
  add->add_flag("--replace", request->replace, "Replace the folder of the type");
  command::add_number(*add, "--reach", request->reach, 0.001, 100.0,
                      "Distance of the tip from the base in m, to compare with that of the URDF");
  add->callback([add, request, actions] { actions.add(*add, *request); });
}

void add_show(CLI::App& robot, const RobotActions& actions) {
  CLI::App* const show = robot.add_subcommand("show", "Show the axes, the inverse and the workspace of an arm");
  auto request = std::make_shared<ShowRequest>();
  show->add_option("ARM", request->arm, "Name of a robot type, or a URDF")->required();
  show->add_option("--base", request->base, "Link at the beginning of the arm in a URDF; default: the root");
  show->add_option("--tip", request->tip, "Link at its end; default: the end of most axes");
  command::add_number(*show, "--postures", request->postures, 1, 1000000, "random postures of the check");
  show->add_option("--picture", request->picture, "PNG file to write: the arm at home; of a robot type");
  show->callback([show, request, actions] { actions.show(*show, *request); });
}

void add_check(CLI::App& robot, const RobotActions& actions) {
  CLI::App* const check = robot.add_subcommand("check", "Compare the kinematics of a robot type with KDL and MuJoCo");
  auto request = std::make_shared<CheckRequest>();
  check->add_option("TYPE", request->type, "Name of a robot type that mrroc robot add has made")->required();
  command::add_number(*check, "--postures", request->postures, 1, 1000000, "random postures");
  check->callback([check, request, actions] { actions.check(*check, *request); });
}

}  // namespace

void add_robot_verbs(CLI::App& robot, const RobotActions& actions) {
  robot.require_subcommand(1);
  add_add(robot, actions);
  add_show(robot, actions);
  add_check(robot, actions);
}

}  // namespace mrroc::cli
