#include "cli/commands/trace_command.hpp"

#include <spdlog/fmt/fmt.h>

#include "cli/output/trace.hpp"
#include "cli/trace/check.hpp"
#include "command/print.hpp"
#include "process/exit_code.hpp"

namespace mrroc::cli {

namespace {

constexpr std::uint64_t kShown = 10;  // violations, unless --all is given

std::string count_of(std::uint64_t number, const std::string& what) {
  return fmt::format("{} {}{}", number, what, number == 1 ? "" : "s");
}

int check(const std::filesystem::path& file, bool all) {
  std::uint64_t reported = 0;
  const trace::Verdict verdict = trace::check_trace(file, [&](const std::string& violation) {
    if (all || reported < kShown) command::print(violation + "\n");
    ++reported;
  });
  for (const std::string& note : verdict.notes) command::print(note + "\n");
  const std::string looked_at =
      fmt::format("{}: {} of {} of {}", file.filename().string(), count_of(verdict.lines, "step"),
                  count_of(verdict.instructions, "instruction"),
                  fmt::format("{} {}", verdict.processes, verdict.processes == 1 ? "process" : "processes"));
  if (verdict.violations == 0) {
    command::print(fmt::format("{}: {} rules hold\n", looked_at, verdict.rules));
    return static_cast<int>(process::ExitCode::success);
  }
  const std::string more =
      reported > kShown && !all ? fmt::format(", the first {} are shown (--all: every one)", kShown) : "";
  command::print(fmt::format("{}: {}{}\n", looked_at, count_of(verdict.violations, "violation"), more));
  return static_cast<int>(process::ExitCode::task_failed);
}

void add_hash(CLI::App& command, int& exit_code) {
  auto file = std::make_shared<std::filesystem::path>();
  CLI::App* hash = command.add_subcommand("hash", "Print the hash of a trace: equal traces, equal hashes");
  hash->add_option("FILE", *file, "Trace file")->required();
  hash->callback([file, &exit_code] {
    command::print(hash_trace(*file) + "\n");
    exit_code = 0;
  });
}

void add_check(CLI::App& command, int& exit_code) {
  struct Arguments {
    std::filesystem::path file;
    bool all = false, rules = false;
  };
  auto arguments = std::make_shared<Arguments>();
  CLI::App* check_command = command.add_subcommand(
      "check", "Check a trace against the laws of Move and Wait, equations (3) and (5), and of coordination");
  CLI::Option* file = check_command->add_option("FILE", arguments->file, "Trace file");
  check_command->add_flag("--all", arguments->all, "Show every violation, not the first ten");
  check_command->add_flag("--rules", arguments->rules, "List the rules and the equations they state")->excludes(file);
  check_command->callback([arguments, file, &exit_code] {
    if (arguments->rules) {
      command::print(trace::text_of_rules());
      exit_code = 0;
      return;
    }
    if (file->count() == 0) throw CLI::RequiredError("FILE");
    exit_code = check(arguments->file, arguments->all);
  });
}

}  // namespace

void add_trace_command(CLI::App& app, int& exit_code) {
  CLI::App* command = app.add_subcommand("trace", "Look at a trace written by `mrroc run --trace`");
  command->require_subcommand(1);
  add_hash(*command, exit_code);
  add_check(*command, exit_code);
}

}  // namespace mrroc::cli
