// ur_controller: a simulated UR controller. `mrroc run` starts it for a robot of the simulated world; by hand it has
// six joints without masses.
#include <signal.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <iostream>
#include <memory>

#include "config/robot_parameters_file.hpp"
#include "config/robot_place.hpp"
#include "process/process.hpp"
#include "process/standard_files.hpp"
#include "sim/ur/world_controller.hpp"

namespace {

using namespace mrroc::sim::ur;

/// Until SIGINT or SIGTERM comes.
void serve(const ControllerServers::Options& options) {
  // blocked before the servers' thread starts, so that only this thread takes them
  sigset_t signals;
  sigemptyset(&signals);
  for (const int signal : {SIGINT, SIGTERM}) sigaddset(&signals, signal);
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);
  ControllerServers servers(options, std::make_unique<ExactJoints>(Six{0, -1.5, 1.5, -1.5, -1.5, 0}));
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
  ControllerServers::Options options;
  CLI::App app{"Simulated UR controller: RTDE, dashboard server, interfaces for programs"};
  app.add_option("--address", options.address, "IPv4 address of its ports")->capture_default_str();
  app.add_option("--rtde-port", options.rtde_port, "0: a free one")->capture_default_str();
  app.add_option("--dashboard-port", options.dashboard_port)->capture_default_str();
  app.add_option("--primary-port", options.primary_port)->capture_default_str();
  app.add_option("--secondary-port", options.secondary_port)->capture_default_str();
  app.add_option("--realtime-port", options.realtime_port)->capture_default_str();
  app.add_flag("--powered", options.controller.powered, "The arm has power and its brakes are released");
  CLI11_PARSE(app, argc, argv);
  serve(options);
  return 0;
} catch (const std::exception& error) {
  std::fputs("ur_controller: ", stderr);
  std::fputs(error.what(), stderr);
  std::fputs("\n", stderr);
  return 1;
}
