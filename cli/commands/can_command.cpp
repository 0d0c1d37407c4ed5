#include "cli/commands/can_command.hpp"

#include <poll.h>
#include <signal.h>
#include <spdlog/fmt/fmt.h>
#include <time.h>
#include <unistd.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <string_view>

#include "cli/can/can_monitor.hpp"
#include "cli/can/can_scan.hpp"
#include "command/number_option.hpp"
#include "command/print.hpp"
#include "command/printable.hpp"
#include "config/drives/io_table.hpp"
#include "config/robot_files.hpp"
#include "config/robot_parameters_file.hpp"

namespace mrroc::cli {

namespace {

/// Blocks Ctrl-C and SIGTERM, and reports whether one has come.
class Interruption {
 public:
  Interruption() {
    sigemptyset(&both_);
    sigaddset(&both_, SIGINT);
    sigaddset(&both_, SIGTERM);
    pthread_sigmask(SIG_BLOCK, &both_, nullptr);
  }
  bool has_come() const {
    sigset_t pending;
    return sigpending(&pending) == 0 && (sigismember(&pending, SIGINT) == 1 || sigismember(&pending, SIGTERM) == 1);
  }
  /// Takes the pending signal; the next one ends the process.
  void release() {
    constexpr timespec kNow{0, 0};
    while (sigtimedwait(&both_, nullptr, &kNow) > 0) {
    }
    pthread_sigmask(SIG_UNBLOCK, &both_, nullptr);
  }

 private:
  sigset_t both_;
};

/// Prints once the reader of the output takes more, or an interruption has come: a pipe without a reader must not keep
/// the process from ending.
void print_unless_interrupted(std::string_view text, Interruption& interruption) {
  constexpr int kGlance = 50;  // ms
  pollfd output{STDOUT_FILENO, POLLOUT, 0};
  while (!interruption.has_come() && poll(&output, 1, kGlance) == 0) {
  }
  if (interruption.has_come()) interruption.release();
  command::print(text);
}

int scan_interface(const std::string& interface, double patience) {
  const auto bus = can::open_bus(interface);
  const ScanResult result = scan(*bus, std::llround(patience * 1e9));
  if (result.nodes.empty()) {
    fmt::print(stderr, "{}", command::printable_lines(silence_text(interface, result.error, patience)));
    return 1;
  }
  command::print(scan_text(result.nodes));
  return 0;
}

struct MonitorArguments {
  std::string interface;
  std::string robot;
  std::filesystem::path drives, io;
  MonitorOptions options;
};

/// The drives of a robot of this type: from `file`, else from the type's own table.
config::DriveTable drives_of(const std::string& type, std::filesystem::path file) {
  const config::RobotFiles files = config::robot_files(type);
  const auto parameters = config::read_robot_parameters(config::Table::load(files.parameters));
  if (file.empty()) file = files.drives;
  return config::read_drive_table(file, parameters);
}

void monitor_interface(const MonitorArguments& arguments) {
  const config::DriveTable drives =
      arguments.robot.empty() ? config::DriveTable{} : drives_of(arguments.robot, arguments.drives);
  CanFrameFormatter words = arguments.robot.empty() ? CanFrameFormatter() : CanFrameFormatter(drives);
  if (!arguments.io.empty()) words.add(config::read_io_table(arguments.io, drives));
  const auto bus = can::open_bus(arguments.interface);
  Interruption interruption;
  bool interrupted = false;
  monitor(
      *bus, words, arguments.options, [&] { return interrupted || (interrupted = interruption.has_come()); },
      [&](std::string_view text) {
        interrupted = interrupted || interruption.has_come();
        print_unless_interrupted(text, interruption);
      });
}

constexpr const char* kInterface = "CAN interface, as can0; or unix:PATH, the bus of simulated drives";

void add_scan(CLI::App& can, int& exit_code) {
  struct Arguments {
    std::string interface;
    double patience = 0.5;
  };
  auto arguments = std::make_shared<Arguments>();
  CLI::App* command = can.add_subcommand("scan", "Identify every node of a CANopen network");
  command->add_option("INTERFACE", arguments->interface, kInterface)->required();
  command::add_number(*command, "--patience", arguments->patience, 0.01, 60.0, "s that an answer may take")
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
  command->add_option("--io", arguments->io, "Table of I/O nodes (TOML): their inputs and outputs are shown");
  command::add_number<std::uint64_t>(*command, "--count", options.count, 1, std::numeric_limits<std::uint64_t>::max(),
                                     "End after so many frames");
  command::add_number(*command, "--seconds", options.seconds, 0.001, 1e9, "End after so long");
  command->add_flag("--summary", options.summary,
                    "No line for each frame: at the end, or after Ctrl-C, how many of each, and the bus load");
  command::add_number(*command, "--bit-rate", options.bit_rate, 1e4, 1e7, "bit/s, for the bus load")
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
