#include "cli/commands/run_command.hpp"

#include <cstdint>
#include <limits>

#include "cli/commands/errors_option.hpp"
#include "cli/processes/ask_programs.hpp"
#include "cli/processes/process_plan.hpp"
#include "cli/run/fault_injector.hpp"
#include "cli/run/runner.hpp"
#include "command/number_option.hpp"
#include "command/print.hpp"
#include "config/clock_names.hpp"
#include "config/description.hpp"
#include "config/entries/driver_entry.hpp"
#include "config/entries/events.hpp"
#include "config/state_machine.hpp"
#include "config/table.hpp"
#include "config/text/calibration_text.hpp"
#include "config/text/deployment_text.hpp"

namespace mrroc::cli {

namespace {

struct RunArguments {
  std::filesystem::path file;
  std::string clock;
  std::filesystem::path events;
  std::optional<std::string> errors;  ///< set for [sim.errors]; none: the deployment's
  std::optional<std::uint32_t> seed;
  RunOptions options;
  bool check = false;
};

/// Rejects options that a deployment on several machines does not support.
void check_hosts(const config::Deployment& deployment, const RunArguments& arguments,
                 const config::DeploymentText& source) {
  const auto used = deployment.hosts_used();
  if (used.empty()) return;
  if (!source.is_file)
    throw config::ConfigurationError(arguments.file, 0, "", "host '" + used.front()->name + "' is another machine",
                                     "a file that every machine has");
  if (deployment.clock != config::ClockMode::real)
    throw config::ConfigurationError(deployment.file, 0, "--clock " + arguments.clock,
                                     "host '" + used.front()->name + "' is another machine", "--clock real");
  if (arguments.options.record_servo_ticks)
    throw config::ConfigurationError(deployment.file, 0, "--record-rate servo",
                                     "host '" + used.front()->name + "' is another machine", "--record-rate step");
  if (!arguments.options.snapshots.empty() && deployment.sim && !deployment.sim->host.empty())
    throw config::ConfigurationError(deployment.file, 0, "--snapshots",
                                     "the simulator runs on host '" + deployment.sim->host + "'",
                                     "a simulator on this machine");
}

/// Real devices go on whatever the clock is, so their drivers need the real clock.
void check_drivers(const config::Deployment& deployment, const RunArguments& arguments) {
  const auto check = [&](const std::string& device, const config::DriverEntry& driver) {
    if (!config::works_under(driver, deployment.clock))
      throw config::ConfigurationError(deployment.file, 0, "--clock " + arguments.clock,
                                       device + " has a real device, of driver '" + driver.name + "'", "--clock real");
  };
  for (const config::RobotEntry& robot : deployment.robots) check("robot '" + robot.name + "'", robot.driver);
  for (const config::SensorEntry& sensor : deployment.sensors)
    if (sensor.driver) check("sensor '" + sensor.name + "'", *sensor.driver);
}

int run(const RunArguments& arguments) {
  config::DeploymentText source = config::read_deployment_text(arguments.file);
  const std::filesystem::path file = source.is_file ? arguments.file : source.file;  // as the command line names it
  config::Deployment deployment = config::load_deployment(file, source.text);
  if (arguments.errors) {
    source.text += errors_table(file, deployment, *arguments.errors, arguments.seed.value_or(1));
    deployment = config::load_deployment(file, source.text);
  }
  RunOptions options = arguments.options;
  options.text = config::with_calibrations(file, source.text);  // read once: a calibration may be written meanwhile
  options.attended = !source.from_stdin;
  options.events = arguments.events;
  deployment.clock = config::clock_named(arguments.clock).value_or(deployment.clock);
  if (!arguments.events.empty()) deployment.events = config::load_events(arguments.events, deployment);
  check_hosts(deployment, arguments, source);
  check_drivers(deployment, arguments);
  if (!deployment.mp.states.empty()) {
    const config::ProgramsByRobot programs = ask_programs(deployment);
    config::load_state_machine(deployment.mp.states, deployment, programs);
    options.behaviours = config::to_text(programs);
  }
  if (arguments.check) {
    check_targets(faults::FaultPlan(options.faults), plan_processes(deployment), deployment);
    command::print(config::describe(deployment) + "\n");
    return 0;
  }
  return static_cast<int>(Runner(deployment, options).run());
}

void add_panel_options(CLI::App& command, RunArguments& arguments) {
  const auto panel = [&arguments]() -> PanelOptions& {
    if (!arguments.options.panel) arguments.options.panel.emplace();
    return *arguments.options.panel;
  };
  command
      .add_option_function<std::vector<std::string>>(
          "--panel",
          [panel](const std::vector<std::string>& words) {
            if (!words.empty() && !words.front().empty()) panel().port = std::stoi(words.front());
            panel();
          },
          "Serve the operator's panel to browsers of this machine, at this port or any free one, and print its URL")
      ->expected(0, 1)
      ->type_name("PORT")
      ->check(CLI::Validator([](const std::string& text) { return command::number_problem<int>(text, 0, 65535); }, ""));
  command.add_option_function<std::string>(
      "--panel-interface", [panel](const std::string& name) { panel().interface = name; },
      "Network device or own address at which the panel is served to other machines, too; needs a certificate");
  command.add_option_function<std::string>(
      "--panel-certificate", [panel](const std::string& path) { panel().certificate = path; },
      "PEM file with certificate and private key of the panel, for TLS");
}

}  // namespace

void add_run_command(CLI::App& app, int& exit_code) {
  auto arguments = std::make_shared<RunArguments>();
  CLI::App* command = app.add_subcommand("run", "Start a deployment, show its progress, exit with the task's result");
  command->add_option("FILE", arguments->file, "Deployment file (TOML)")->required();
  command->add_option("--clock", arguments->clock, "Clock instead of the deployment's")
      ->check(CLI::IsMember(config::clock_names()));
  command->add_option("--record,--trace", arguments->options.recording,
                      "Record every step, state, reading and command to this MCAP file (docs/reference/recording.md)");
  command
      ->add_option_function<std::string>(
          "--record-rate",
          [arguments](const std::string& rate) { arguments->options.record_servo_ticks = rate == "servo"; },
          "Record each step only, or each tick of each servo, too")
      ->needs("--record")
      ->check(CLI::IsMember({"step", "servo"}))
      ->default_str("step");
  command::add_number(*command, "--record-last", arguments->options.record_last, 1.0, 3600.0,
                      "Keep the last seconds in memory, and write the file only when the run fails")
      ->needs("--record")
      ->type_name("SECONDS");
  arguments->options.black_box = "mrroc-black-box";
  const CLI::Option* const black_box =
      command
          ->add_option("--black-box", arguments->options.black_box,
                       "Folder for the last steps of a task that fails, one file for each; empty: none")
          ->capture_default_str();
  command->add_option("--snapshots", arguments->options.snapshots,
                      "Write states of the simulated world to this folder");
  command->add_option("--motion", arguments->options.motion,
                      "Write where the simulated world's robots are at every tick, and how fast, to this file; of a "
                      "simulator on another host it lies there");
  command
      ->add_option(
          "--inject", arguments->options.faults,
          "Inject a fault, e.g. \"kill ecp:arm at step 120\" (docs/how-to/fault-injection.md); may be given again")
      ->take_all()
      ->expected(1);
  command::add_number<std::uint64_t>(*command, "--shuffle-start", arguments->options.shuffle_seed, 0,
                                     std::numeric_limits<std::uint64_t>::max(),
                                     "Start the processes in a random order with random delays, from this seed");
  CLI::Option* errors = command->add_option(
      "--errors", arguments->errors,
      "Errors of the simulated world: a set as 'modest', or a file with sizes (docs/reference/simulated-errors.md)");
  command::add_number<std::uint32_t>(*command, "--seed", arguments->seed, 0, std::numeric_limits<std::uint32_t>::max(),
                                     "Seed of these errors; 1 when left out")
      ->needs(errors);
  command->add_flag("--hold", arguments->options.hold, "The task waits for the operator's 'start'");
  command->add_option("--events", arguments->events,
                      "Operator commands at given ticks, [[events]], instead of the deployment's");
  command->add_option("--note-events", arguments->options.note_events,
                      "Write the operator's commands, each with its tick, to this file for --events");
  add_panel_options(*command, *arguments);
  command->add_flag("--ros2", arguments->options.ros2,
                    "Show the run to ROS 2 as a node, as the deployment's table [ros2] does");
  command->add_flag("--quiet", arguments->options.quiet, "No progress and no report");
  command->add_flag("--check", arguments->check, "Validate the deployment and show its processes; start nothing");
  command->callback([arguments, black_box, &exit_code] {
    arguments->options.black_box_named = black_box->count() > 0;
    exit_code = run(*arguments);
  });
}

}  // namespace mrroc::cli
