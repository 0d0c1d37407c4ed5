#pragma once

#include <CLI/CLI.hpp>
#include <map>
#include <memory>
#include <string>

#include "cli/operator/socket/run_connection.hpp"
#include "config/deployment.hpp"

namespace mrroc::cli {

/// A run as a program beside it gets it.
struct WatchedRun {
  RunConnection connection;
  config::Deployment deployment;
  bool simulated;                                   ///< whether its clock is
  std::map<std::string, std::string> camera_files;  ///< pictures of hardware cameras (process::PictureMemory)
};

/// A program beside a run, such as the panel's server.
class SideProgram {
 public:
  virtual ~SideProgram() = default;

  /// What it does, for --help.
  virtual const char* description() const = 0;
  /// Adds its own arguments to DEPLOYMENT and --socket, which say which run.
  virtual void add_options(CLI::App& /*app*/) {}
  /// Ends when the run does, or when `stop`, a descriptor, becomes readable: SIGTERM, SIGINT, SIGHUP.
  virtual void serve(WatchedRun run, int stop) = 0;
};

/// The main function of one: reads the arguments, connects to the run, loads its deployment and serves. An error is one
/// line on stderr behind the program's name, and exit code 2. Returns the exit code. The main thread, before any other.
int side_main(int argc, char** argv, std::unique_ptr<SideProgram> (*make)());

}  // namespace mrroc::cli
