#include "cli/commands/trace_command.hpp"

#include <spdlog/fmt/fmt.h>

#include <cstdio>
#include <functional>
#include <utility>

#include "cli/commands/plot_command.hpp"
#include "cli/record/recording_json.hpp"
#include "cli/trace/check.hpp"
#include "cli/trace/diff.hpp"
#include "cli/trace/hash.hpp"
#include "command/print.hpp"
#include "process/exit_code.hpp"

namespace mrroc::cli {

namespace {

constexpr std::uint64_t kShown = 10;  // violations, unless --all is given

std::string count_of(std::uint64_t number, const std::string& what) {
  return fmt::format("{} {}{}", number, what, number == 1 ? "" : "s");
}

/// On stderr: what a program reads from the standard output stays what it is.
void note_early_end(const std::filesystem::path& file) {
  std::fputs(("mrroc: " + file.string() + ": note: ends early: the run was killed, or its disk was full\n").c_str(),
             stderr);
}

int check(const std::filesystem::path& file, bool all) {
  std::uint64_t reported = 0;
  const std::function<void(const std::string&)> report = [&](const std::string& violation) {
    if (all || reported < kShown) command::print(violation + "\n");
    ++reported;
  };
  const trace::Verdict verdict = trace::check_trace(file, report);
  if (!verdict.complete) note_early_end(file);
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
  CLI::App* hash = command.add_subcommand("hash", "Print the hash of a run's steps: equal runs, equal hashes");
  hash->add_option("FILE", *file, "Recording (MCAP)")->required();
  hash->callback([file, &exit_code] {
    const trace::Hash found = trace::hash_of(*file);
    if (!found.complete) note_early_end(*file);
    command::print(found.text + "\n");
    exit_code = 0;
  });
}

int diff(const std::filesystem::path& first, const std::filesystem::path& second) {
  trace::Reader one(first), other(second);
  const trace::Comparison found = trace::compare(one, other);
  if (!found.difference) {
    command::print(fmt::format("equal: {}\n", count_of(found.steps, "step")));
    return static_cast<int>(process::ExitCode::success);
  }
  const trace::Difference& difference = *found.difference;
  command::print(fmt::format("{}{}{}: {} in {}, {} in {}; {} before are equal\n", difference.place,
                             difference.field.empty() ? "" : ": ", difference.field, difference.first, first.string(),
                             difference.second, second.string(), count_of(found.steps, "step")));
  return static_cast<int>(process::ExitCode::task_failed);
}

void add_diff(CLI::App& command, int& exit_code) {
  struct Arguments {
    std::filesystem::path first, second;
  };
  auto arguments = std::make_shared<Arguments>();
  CLI::App* diff_command = command.add_subcommand(
      "diff", "Name the first difference of two runs: process, instruction, step, field, both values");
  diff_command->add_option("FIRST", arguments->first, "Recording (MCAP)")->required();
  diff_command->add_option("SECOND", arguments->second, "Recording (MCAP)")->required();
  diff_command->callback([arguments, &exit_code] { exit_code = diff(arguments->first, arguments->second); });
}

void add_cat(CLI::App& command, int& exit_code) {
  auto file = std::make_shared<std::filesystem::path>();
  CLI::App* cat = command.add_subcommand("cat", "Print each message of a recording as one line of JSON");
  cat->add_option("FILE", *file, "Recording (MCAP)")->required();
  cat->callback([file, &exit_code] {
    exit_code = 0;
    const bool complete =
        record::print_json(*file, [](std::string_view line) { command::print(std::string{line} + "\n"); });
    if (!complete) note_early_end(*file);
  });
}

void add_check(CLI::App& command, int& exit_code) {
  struct Arguments {
    std::filesystem::path file;
    bool all = false, rules = false;
  };
  auto arguments = std::make_shared<Arguments>();
  CLI::App* check_command = command.add_subcommand(
      "check", "Check a recording against the laws of Move and Wait, equations (3) and (5), and of coordination");
  CLI::Option* file = check_command->add_option("FILE", arguments->file, "Recording (MCAP)");
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
  CLI::App* command = app.add_subcommand("trace", "Look at a recording of `mrroc run --record`, or a black box");
  command->require_subcommand(1);
  add_hash(*command, exit_code);
  add_check(*command, exit_code);
  add_cat(*command, exit_code);
  add_diff(*command, exit_code);
  add_plot_command(*command, exit_code);
}

}  // namespace mrroc::cli
