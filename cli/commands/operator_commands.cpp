#include "cli/commands/operator_commands.hpp"

#include <spdlog/fmt/fmt.h>
#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <map>
#include <memory>
#include <string>

#include "cli/operator/operator_state.hpp"
#include "cli/operator/operator_verbs.hpp"
#include "cli/operator/socket/run_connection.hpp"
#include "cli/operator/socket/socket_folder.hpp"
#include "command/print.hpp"
#include "command/printable.hpp"
#include "process/exit_code.hpp"

namespace mrroc::cli {

namespace {

using process::ExitCode;

struct GivenArguments {
  std::string deployment;
  std::map<std::string, std::string> values;
  bool json = false;
};

ExitCode code_of(const VerbReply& reply) {
  if (reply.ok()) return ExitCode::success;
  const bool wrong = reply.refusal == Refusal::invalid_argument || reply.refusal == Refusal::unknown_verb ||
                     reply.refusal == Refusal::malformed;
  return wrong ? ExitCode::usage : ExitCode::task_failed;
}

/// Prints what the run publishes until it ends.
void follow(RunConnection& run, bool json) {
  while (const std::optional<std::string> line = run.next_line(-1)) {
    const std::string text = json ? *line : event_text(*line);
    if (!text.empty()) command::print(text + "\n");
  }
}

ExitCode execute(const OperatorVerb& verb, const GivenArguments& arguments) {
  RunConnection run = RunConnection::to(arguments.deployment);
  std::map<std::string, std::string> given;
  for (const auto& [name, value] : arguments.values)
    if (!value.empty()) given.emplace(name, value);
  for (const VerbArgument& argument : verb.arguments)  // the run has another working folder
    if (const auto path = given.find(std::string{argument.name}); argument.file && path != given.end())
      path->second = std::filesystem::absolute(path->second).string();
  const std::string name = run.deployment() + ": ";
  const auto say_that_it_lasts = [&] {
    if (isatty(STDERR_FILENO) != 0)
      std::fprintf(stderr, "%s\n",
                   command::printable(name + "waiting for the end of '" + std::string{verb.name} + "'").c_str());
  };
  const VerbReply reply = run.request(verb.name, given, say_that_it_lasts);
  if (!reply.ok()) {
    std::fflush(stdout);
    std::fprintf(stderr, "mrroc: %s\n", command::printable(name + to_text(reply)).c_str());
    return code_of(reply);
  }
  if (verb.name == "status")
    command::print(arguments.json ? reply.data + "\n" : state_text(reply.data));
  else if (!arguments.json)
    command::print(name + reply.text + (reply.tick ? " [tick " + std::to_string(*reply.tick) + "]" : "") + "\n");
  if (verb.name == "command") run.request("echo");
  if (verb.name == "command" || verb.name == "echo") follow(run, arguments.json);
  return ExitCode::success;
}

ExitCode list(bool json) {
  std::string lines;
  for (const std::filesystem::path& socket : operator_sockets()) {
    try {
      RunConnection run(socket);
      const VerbReply reply = run.request("status");
      lines += json ? (lines.empty() ? "" : ",\n ") + reply.data : run_line(run.deployment(), run.pid(), reply.data);
    } catch (const std::runtime_error& error) {
      // a run that ends just now is not an error of the list
      if (!json) lines += command::printable(socket.stem().string() + ": " + error.what()) + "\n";
    }
  }
  if (json)
    command::print("[" + lines + "]\n");
  else
    command::print(lines.empty() ? "no deployment of this user runs on this machine\n" : lines);
  return ExitCode::success;
}

void add_verb(CLI::App& app, const OperatorVerb& verb, int& exit_code) {
  CLI::App* command = app.add_subcommand(std::string{verb.name}, std::string{verb.summary});
  auto arguments = std::make_shared<GivenArguments>();
  for (const VerbArgument& argument : verb.arguments) {
    std::string& value = arguments->values[std::string{argument.name}];
    std::string name{argument.name};
    for (char& letter : name) letter = static_cast<char>(argument.required ? std::toupper(letter) : letter);
    CLI::Option* const option =
        command->add_option(argument.required ? name : "--" + name, value, std::string{argument.summary});
    if (argument.required) option->required();
  }
  const char* const kDeployment = "Name of the deployment, or NAME-PID; default: the only run";
  // behind arguments of the verb a name would be taken for one of them
  if (verb.arguments.empty())
    command->add_option("DEPLOYMENT", arguments->deployment, kDeployment);
  else
    command->add_option("--deployment,-d", arguments->deployment, kDeployment);
  if (verb.name == "status" || verb.name == "echo")
    command->add_flag("--json", arguments->json, "As JSON, one line each");
  command->callback([&verb, arguments, &exit_code] { exit_code = static_cast<int>(execute(verb, *arguments)); });
}

}  // namespace

void add_operator_commands(CLI::App& app, int& exit_code) {
  CLI::App* const command = app.add_subcommand("list", "List the runs of this user on this machine");
  auto json = std::make_shared<bool>(false);
  command->add_flag("--json", *json, "As JSON: an array of states");
  command->callback([json, &exit_code] { exit_code = static_cast<int>(list(*json)); });
  for (const OperatorVerb& verb : operator_verbs())
    if (verb.name != "release") add_verb(app, verb, exit_code);  // for it a connection must last
}

}  // namespace mrroc::cli
