// ur_controller: a simulated UR controller. `mrroc run` starts it for a robot of the simulated world; by hand it has
// six joints without masses.
#include <signal.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <iostream>
#include <memory>
#include <utility>
#include <vector>

#include "command/number_option.hpp"
#include "command/parse_command.hpp"
#include "command/printable.hpp"
#include "config/robot_parameters_file.hpp"
#include "config/robot_place.hpp"
#include "process/process.hpp"
#include "process/standard_files.hpp"
#include "sim/ur/world_controller.hpp"

namespace {

using namespace mrroc::sim::ur;

/// Until SIGINT or SIGTERM comes.
void serve(const ControllerServers::Options& options, const Six& start, const std::vector<double>& load) {
  // blocked before the servers' thread starts, so that only this thread takes them
  sigset_t signals;
  sigemptyset(&signals);
  for (const int signal : {SIGINT, SIGTERM}) sigaddset(&signals, signal);
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);
  auto joints = std::make_unique<ExactJoints>(start);
  if (!load.empty()) joints->set_load(Eigen::Map<const mrroc::Wrench>(load.data()));
  ControllerServers servers(options, std::move(joints));
  std::cout << "RTDE " << options.address << ":" << servers.ports().rtde << std::endl;
  int signal = 0;
  sigwait(&signals, &signal);
}

/// The ports of the robot for which this process stands in.
ControllerServers::Options options_of(const mrroc::config::DriverEntry& driver) {
  ControllerServers::Options options;
  options.address = driver.text("address");
  options.rtde_port = static_cast<int>(driver.number("rtde_port"));
  options.dashboard_port = static_cast<int>(driver.number("dashboard_port"));
  options.secondary_port = static_cast<int>(driver.number("script_port"));
  options.primary_port = options.realtime_port = 0;  // which the driver does not use
  options.lockstep_register = static_cast<int>(driver.number("registers"));
  options.controller.tool_terminals = static_cast<int>(driver.number("tool_terminals"));
  return options;
}

/// As a process of a deployment.
int serve_deployment(int argc, char** argv) {
  mrroc::process::open_standard_files();
  return mrroc::process::run_process(argc, argv, mrroc::links::ProcessRole::sim, [](mrroc::process::Process& process) {
    const mrroc::config::RobotPlace place = mrroc::config::robot_of_process(process.deployment(), process.name());
    const auto file = mrroc::config::Table::load(place.entry.files().parameters);
    serve_world_controller(process, mrroc::config::read_robot_parameters(file), place.index,
                           options_of(place.entry.driver));
  });
}

}  // namespace

int main(int argc, char** argv) try {
  if (argc > 1 && std::string(argv[1]) == "--deployment") return serve_deployment(argc, argv);
  mrroc::process::open_standard_files();
  ControllerServers::Options options;
  CLI::App app{"Simulated UR controller: RTDE, dashboard server, interfaces for programs"};
  app.add_option("--address", options.address, "IPv4 address of its ports")->capture_default_str();
  const auto add_port = [&app](const std::string& name, int& port) {
    mrroc::command::add_number<int>(app, name, port, 0, 65535, "0: a free one")->capture_default_str();
  };
  add_port("--rtde-port", options.rtde_port);
  add_port("--dashboard-port", options.dashboard_port);
  add_port("--primary-port", options.primary_port);
  add_port("--secondary-port", options.secondary_port);
  add_port("--realtime-port", options.realtime_port);
  mrroc::command::add_number<double>(app, "--clock-rate", options.clock_rate, 0.5, 2,
                                     "Seconds of its clock in a second of the host")
      ->capture_default_str();
  Six joints{0, -1.5, 1.5, -1.5, -1.5, 0};
  app.add_option("--joints", joints, "Where the arm is at the start, rad")->capture_default_str();
  app.add_flag("--powered", options.controller.powered, "The arm has power and its brakes are released");
  std::string polyscope = "5.11";
  app.add_option("--polyscope", polyscope, "Version of its software, MAJOR.MINOR; below 5: of a CB3")
      ->check(CLI::IsMember({"3.4", "3.15", "5.4", "5.11"}))
      ->capture_default_str();
  std::vector<double> load;
  app.add_option("--load", load, "On the flange, in its frame: 3 forces (N), 3 torques (N m)")->expected(6);
  if (const auto exit_code = mrroc::command::parse_command(app, argc, argv)) return *exit_code;
  options.controller.version.major = static_cast<std::uint32_t>(std::stoul(polyscope));
  options.controller.version.minor = static_cast<std::uint32_t>(std::stoul(polyscope.substr(2)));
  serve(options, joints, load);
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "ur_controller: %s\n", mrroc::command::printable_lines(error.what()).c_str());
  return 2;
}
