#include "cli/commands/calibrate_command.hpp"

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>

#include "cli/commands/errors_option.hpp"
#include "cli/processes/ask_programs.hpp"
#include "cli/run/calibration_run.hpp"
#include "cli/run/runner.hpp"
#include "command/number_option.hpp"
#include "config/clock_names.hpp"
#include "config/state_machine.hpp"
#include "config/table.hpp"
#include "config/text/calibration_text.hpp"
#include "config/text/deployment_text.hpp"
#include "config/text/message_text.hpp"

namespace mrroc::cli {

namespace {

struct CalibrateArguments {
  CalibrationKind kind;
  std::filesystem::path file;
  CalibrationOrder order;
  std::string clock;
  std::optional<std::string> errors;
  std::optional<std::uint32_t> seed;
  RunOptions options;
};

int calibrate(const CalibrateArguments& arguments) {
  config::DeploymentText source = config::read_deployment_text(arguments.file);
  const std::filesystem::path file = source.is_file ? arguments.file : source.file;
  config::Deployment deployment = config::load_deployment(file, source.text);
  if (!deployment.hosts_used().empty())
    throw config::ConfigurationError(file, 0, "hosts", "the deployment uses several machines",
                                     "all robots and sensors on this one");
  if (arguments.errors) source.text += errors_table(file, deployment, *arguments.errors, arguments.seed.value_or(1));
  const CalibrationRun calibration(arguments.kind, deployment, arguments.order);
  RunOptions options = arguments.options;
  options.text = calibration.deployment_text(config::with_calibrations(file, source.text));
  options.attended = !source.from_stdin;
  deployment = config::load_deployment(file, options.text);
  deployment.clock = config::clock_named(arguments.clock).value_or(deployment.clock);
  const config::ProgramsByRobot programs = ask_programs(deployment);
  config::load_state_machine(deployment.mp.states, deployment, programs);
  options.behaviours = config::to_text(programs);
  return static_cast<int>(Runner(deployment, options).run());
}

std::string option_of(std::string name) {
  for (char& c : name)
    if (c == '_') c = '-';
  return "--" + name;
}

void add_settings(CLI::App& command, CalibrateArguments& arguments) {
  for (CalibrationSetting& setting : arguments.kind.settings) {
    if (setting.whole) {
      command
          .add_option_function<int>(
              option_of(setting.name), [&setting](const int& value) { setting.value = value; }, setting.text)
          ->check(CLI::Validator(
              [&setting](const std::string& text) {
                return command::number_problem<int>(text, static_cast<int>(setting.min), static_cast<int>(setting.max));
              },
              ""));
    } else {
      CLI::Option* const option = command::add_number<double>(command, option_of(setting.name), setting.value,
                                                              setting.min, setting.max, setting.text);
      if (setting.required)
        option->required();
      else
        option->capture_default_str();
    }
  }
}

void add_kind(CLI::App& calibrate_verb, const CalibrationKind& kind, int& exit_code) {
  auto arguments = std::make_shared<CalibrateArguments>();
  arguments->kind = kind;
  CLI::App* const command = calibrate_verb.add_subcommand(kind.name, kind.text);
  command->add_option("DEPLOYMENT", arguments->file, "Deployment file (TOML)")->required();
  command->add_option("--into", arguments->order.into, "The calibration file that is written when it is accepted")
      ->required();
  command->add_option("--robot", arguments->order.robot, "Robot that moves; left out: the only one in question");
  command->add_option("--sensor", arguments->order.sensor,
                      std::string{kind.on_robot ? "Its sensor" : "Sensor that does not move,"} + " of type " +
                          kind.sensor_type + "; left out: the only one");
  command->add_option("--clock", arguments->clock, "Clock instead of the deployment's")
      ->check(CLI::IsMember(config::clock_names()));
  CLI::Option* const errors =
      command->add_option("--errors", arguments->errors, "Errors of the simulated world, as of 'mrroc run'");
  command::add_number<std::uint32_t>(*command, "--seed", arguments->seed, 0, std::numeric_limits<std::uint32_t>::max(),
                                     "Seed of these errors; 1 when left out")
      ->needs(errors);
  command->add_option("--record,--trace", arguments->options.recording,
                      "Record every step, state, reading and command to this MCAP file (docs/reference/recording.md)");
  command->add_flag("--quiet", arguments->options.quiet, "Only the lines of the calibration");
  add_settings(*command, *arguments);
  command->callback([arguments, &exit_code] { exit_code = calibrate(*arguments); });
}

}  // namespace

void add_calibrate_command(CLI::App& app, int& exit_code) {
  CLI::App* const command =
      app.add_subcommand("calibrate", "Measure a number of the cell with its own robots, write it into a file");
  command->allow_extras();  // reported below, with the kinds that exist
  for (const CalibrationKind& kind : calibration_kinds()) add_kind(*command, kind, exit_code);
  command->parse_complete_callback([command] {
    if (!command->get_subcommands().empty()) return;
    std::vector<std::string> kinds;
    for (const CalibrationKind& kind : calibration_kinds()) kinds.push_back(kind.name);
    const std::vector<std::string> words = command->remaining();
    throw CLI::ValidationError("calibrate",
                               (words.empty() ? "a kind is missing" : "no kind " + config::in_quotes(words.front())) +
                                   ", expected " + config::alternatives(kinds));
  });
}

}  // namespace mrroc::cli
