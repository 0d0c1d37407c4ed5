#include "cli/can_command.hpp"

#include <signal.h>
#include <spdlog/fmt/fmt.h>

#include <cmath>
#include <memory>

#include "cli/can_monitor.hpp"
#include "cli/can_scan.hpp"
#include "config/robot_parameters_file.hpp"

namespace mrroc::cli {

namespace {

/// Blocks ctrl-C and SIGTERM, and tells whether one has come.
class Interruption {
 public:
  Interruption() {
    sigset_t both;
    sigemptyset(&both);
    sigaddset(&both, SIGINT);
    sigaddset(&both, SIGTERM);
    pthread_sigmask(SIG_BLOCK, &both, nullptr);
  }
  bool has_come() const {
    sigset_t pending;
    return sigpending(&pending) == 0 && (sigismember(&pending, SIGINT) == 1 || sigismember(&pending, SIGTERM) == 1);
  }
};

int scan_interface(const std::string& interface, double patience) {
  const auto bus = can::open_bus(interface);
  const ScanResult result = scan(*bus, std::llround(patience * 1e9));
  if (result.nodes.empty()) {
    fmt::print(stderr, "{}", silence_text(interface, result.error, patience));
    return 1;
  }
  fmt::print("{}", scan_text(result.nodes));
  return 0;
}

struct MonitorArguments {
  std::string interface;
  std::string robot;
  std::filesystem::path drives;
  MonitorOptions options;
};

/// The drives of a robot of this type: the type's own table, or `file`.
config::DriveTable drives_of(const std::string& type, std::filesystem::path file) {
  const auto parameters = config::read_robot_parameters(config::Table::load(config::robot_file(type, type + ".toml")));
  if (file.empty()) file = config::robot_file(type, type + "_drives.toml");
  return config::read_drive_table(file, parameters);
}

void monitor_interface(const MonitorArguments& arguments) {
  FrameWords words = arguments.robot.empty() ? FrameWords() : FrameWords(drives_of(arguments.robot, arguments.drives));
  const auto bus = can::open_bus(arguments.interface);
  const Interruption interruption;
  std::setvbuf(stdout, nullptr, _IOLBF, BUFSIZ);
  monitor(
      *bus, words, arguments.options, [&interruption] { return interruption.has_come(); }, stdout);
}

constexpr const char* kInterface = "CAN interface, as can0; or unix:PATH, the bus of simulated drives";

void add_scan(CLI::App& can, int& exit_code) {
  struct Arguments {
    std::string interface;
    double patience = 0.5;
  };
  auto arguments = std::make_shared<Arguments>();
  CLI::App* command = can.add_subcommand("scan", "Ask every node of a CANopen network what it is");
  command->add_option("INTERFACE", arguments->interface, kInterface)->required();
  command->add_option("--patience", arguments->patience, "s that an answer may take")
      ->check(CLI::Range(0.01, 60.0))
      ->capture_default_str();
  command->callback([arguments, &exit_code] { exit_code = scan_interface(arguments->interface, arguments->patience); });
}

void add_monitor(CLI::App& can, int& exit_code) {
  auto arguments = std::make_shared<MonitorArguments>();
  MonitorOptions& options = arguments->options;
  CLI::App* command = can.add_subcommand("monitor", "Print the frames of a CANopen network in words");
  command->add_option("INTERFACE", arguments->interface, kInterface)->required();
  CLI::Option* robot = command->add_option("--robot", arguments->robot, "Robot type: its drives are called by axis");
  command->add_option("--drives", arguments->drives, "Table of the robot's drives (TOML), not the type's own")
      ->needs(robot);
  command->add_option("--count", options.count, "End after so many frames");
  command->add_option("--seconds", options.seconds, "End after so long")->check(CLI::PositiveNumber);
  command->add_flag("--summary", options.summary,
                    "No line for each frame: at the end, or after Ctrl-C, how many of each, and the bus load");
  command->add_option("--bit-rate", options.bit_rate, "bit/s, for the bus load")
      ->check(CLI::Range(1e4, 1e7))
      ->capture_default_str();
  command->callback([arguments, &exit_code] {
    monitor_interface(*arguments);
    exit_code = 0;
  });
}

}  // namespace

void add_can_command(CLI::App& app, int& exit_code) {
  CLI::App* command = app.add_subcommand("can", "Look at a CAN bus with CANopen drives");
  command->require_subcommand(1);
  add_scan(*command, exit_code);
  add_monitor(*command, exit_code);
}

}  // namespace mrroc::cli
