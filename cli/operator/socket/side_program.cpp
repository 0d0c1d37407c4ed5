#include "cli/operator/socket/side_program.hpp"

#include <signal.h>

#include <cstdio>
#include <exception>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "command/parse_command.hpp"
#include "command/printable.hpp"
#include "process/signals/stop_signals.hpp"
#include "process/standard_files.hpp"

namespace mrroc::cli {

namespace {

WatchedRun watch(RunConnection connection) {
  const auto status = nlohmann::json::parse(connection.request("status").data);
  return {std::move(connection), config::load_deployment(status.at("file").get<std::string>()),
          status.at("clock").get<std::string>() != "real",
          status.value("cameras", std::map<std::string, std::string>{})};
}

}  // namespace

int side_main(int argc, char** argv, std::unique_ptr<SideProgram> (*make)()) {
  process::open_standard_files();
  signal(SIGPIPE, SIG_IGN);
  try {
    const int stop = process::stop_signals();
    const std::unique_ptr<SideProgram> program = make();
    CLI::App app{program->description()};
    program->add_options(app);
    std::string name;
    std::string socket;
    app.add_option("DEPLOYMENT", name, "Name of the deployment, or NAME-PID; default: the only run");
    app.add_option("--socket", socket, "Socket of the run, instead of its name");
    if (const auto exit_code = command::parse_command(app, argc, argv)) return *exit_code;
    program->serve(watch(socket.empty() ? RunConnection::to(name) : RunConnection(socket)), stop);
  } catch (const std::exception& error) {
    std::fflush(stdout);
    const std::string program = std::filesystem::path(argv[0]).filename();
    std::fprintf(stderr, "%s: %s\n", program.c_str(), command::printable_lines(error.what()).c_str());
    return 2;
  }
  return 0;
}

}  // namespace mrroc::cli
