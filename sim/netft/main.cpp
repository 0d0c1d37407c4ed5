// netft_sensor: a simulated ATI Net F/T. `mrroc run` starts it for a sensor of the simulated world; by hand it has a
// load and faults that are typed.
#include <poll.h>

#include <CLI/CLI.hpp>
#include <csignal>
#include <cstdio>
#include <iostream>
#include <memory>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "command/number_option.hpp"
#include "command/parse_command.hpp"
#include "command/printable.hpp"
#include "core/number_text.hpp"
#include "process/process.hpp"
#include "process/standard_files.hpp"
#include "sim/netft/netft_process.hpp"

namespace {

using mrroc::Wrench;
using mrroc::sim::NetftFaults;
using mrroc::sim::NetftServer;
using mrroc::sim::NetftSettings;

constexpr const char* kCommands =
    "load FX FY FZ TX TY TZ (N, N m), silent on|off, deaf on|off, frozen on|off, loss P, doubled P, reordered P, "
    "garbage P, status WORD, restart, clear";

mrroc::sim::NetftLoad constant(const Wrench& load) {
  return [load](double) { return load; };
}

/// One command of the standard input.
class Commands {
 public:
  explicit Commands(NetftServer& server) : server_(server) {}

  /// False: not a command.
  bool obey(const std::string& line) {
    std::istringstream words(line);
    std::string verb;
    if (!(words >> verb)) return true;
    std::vector<std::string> values;
    for (std::string value; words >> value;) values.push_back(value);
    if (verb == "load") return set_load(values);
    if (verb == "restart" && values.empty()) return server_.restart(), true;
    if (verb == "clear" && values.empty()) {
      faults_ = {};
    } else if (values.size() != 1 || !set_fault(verb, values[0])) {
      return false;
    }
    server_.set_faults(faults_);
    return true;
  }

 private:
  bool set_load(const std::vector<std::string>& values) {
    if (values.size() != 6) return false;
    Wrench load;
    for (std::size_t i = 0; i < 6; ++i) {
      const auto value = mrroc::core::to_finite(values[i]);
      if (!value) return false;
      load[static_cast<int>(i)] = *value;
    }
    server_.set_load(constant(load));
    return true;
  }

  bool set_fault(const std::string& verb, const std::string& value) {
    if (verb == "silent") return set_switch(faults_.silent, value);
    if (verb == "deaf") return set_switch(faults_.deaf, value);
    if (verb == "frozen") return set_switch(faults_.frozen, value);
    if (verb == "loss") return set_probability(faults_.loss, value);
    if (verb == "doubled") return set_probability(faults_.doubled, value);
    if (verb == "reordered") return set_probability(faults_.reordered, value);
    if (verb == "garbage") return set_probability(faults_.garbage, value);
    if (verb != "status") return false;
    const auto status = mrroc::core::to_literal(value);
    if (!status || *status > 0xffff'ffff) return false;
    faults_.status = static_cast<std::uint32_t>(*status);
    return true;
  }

  static bool set_switch(bool& fault, const std::string& value) {
    fault = value == "on";
    return fault || value == "off";
  }
  static bool set_probability(double& fault, const std::string& value) {
    const auto number = mrroc::core::to_finite(value);
    if (!number || *number < 0 || *number > 1) return false;
    fault = *number;
    return true;
  }

  NetftServer& server_;
  NetftFaults faults_;
};

int serve_by_hand(int argc, char** argv) {
  mrroc::process::open_standard_files();
  NetftSettings settings;
  std::vector<double> load(6, 0.0);
  CLI::App app{"A simulated ATI Net F/T. Commands on its standard input, until its end: " + std::string(kCommands)};
  app.add_option("--address", settings.address, "on which it is reached");
  mrroc::command::add_number<std::uint16_t>(app, "--port", settings.port, 0, 65535, "UDP port of RDT; 0: a free one");
  mrroc::command::add_number<std::uint16_t>(app, "--http-port", settings.http_port, 0, 65535,
                                            "TCP port of netftapi2.xml; 0: a free one");
  mrroc::command::add_number(app, "--rate", settings.rate, 1.0, mrroc::netft::kMaxRate, "records per second");
  mrroc::command::add_number<std::uint32_t>(app, "--buffer", settings.buffer, 1, mrroc::netft::kMaxRecords,
                                            "records in a packet of the buffered mode");
  mrroc::command::add_number(app, "--counts-per-force", settings.counts_per_force, 1e-3, 1e12,
                             "counts in a force unit");
  mrroc::command::add_number(app, "--counts-per-torque", settings.counts_per_torque, 1e-3, 1e12,
                             "counts in a torque unit");
  app.add_option("--force-unit", settings.force_unit, "N, kN, lbf, klbf, kgf or gf");
  app.add_option("--torque-unit", settings.torque_unit, "N-m, N-mm, kN-m, lbf-in, lbf-ft or kgf-cm");
  app.add_option("--load", load, "force x, y, z (N) and torque x, y, z (N m)")->expected(6);
  app.add_flag("--one-client", settings.one_client, "a new stream ends that of another client");
  if (const auto exit_code = mrroc::command::parse_command(app, argc, argv)) return *exit_code;
  NetftServer server(settings, constant(Wrench{load.data()}));
  std::printf("netft_sensor: %s, RDT on UDP port %u, configuration page on TCP port %u\n", settings.address.c_str(),
              static_cast<unsigned>(server.port()), static_cast<unsigned>(server.http_port()));
  std::fflush(stdout);
  Commands commands(server);
  for (std::string line; std::getline(std::cin, line);) {
    const bool done = commands.obey(line);
    std::printf("%s\n", done ? "done" : ("not a command, expected " + std::string(kCommands)).c_str());
    std::fflush(stdout);
  }
  return 0;
}

/// The settings of the sensor for which this process stands in.
NetftSettings settings_of(const mrroc::process::Process& process) {
  const auto& deployment = process.deployment();
  const auto& driver = *deployment.sensors[mrroc::sim::sensor_of_process(deployment, process.name())].driver;
  NetftSettings settings;
  settings.address = driver.text("address");
  settings.port = static_cast<std::uint16_t>(driver.number("port"));
  settings.http_port = static_cast<std::uint16_t>(driver.number("http_port"));
  settings.one_client = true;
  return settings;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc > 1 && std::string(argv[1]) == "--deployment") {
    mrroc::process::open_standard_files();
    return mrroc::process::run_process(
        argc, argv, mrroc::links::ProcessRole::sim,
        [](mrroc::process::Process& process) { mrroc::sim::serve_netft(process, settings_of(process)); });
  }
  try {
    return serve_by_hand(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "netft_sensor: %s\n", mrroc::command::printable_lines(error.what()).c_str());
    return 2;
  }
}
