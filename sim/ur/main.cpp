// A simulated UR controller with six joints without masses, for clients that need one without a deployment.
#include <signal.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <iostream>
#include <memory>

#include "sim/ur/controller_servers.hpp"

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

}  // namespace

int main(int argc, char** argv) try {
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
