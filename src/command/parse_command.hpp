#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

namespace mrroc::command {

/// The words behind the program's name in the form for `app`: `--name=` becomes `--name` and an empty value, for CLI11
/// 2.1 takes the next word instead. Throws CLI::ParseError for a flag with a value.
std::vector<std::string> words_of(CLI::App& app, const std::vector<std::string>& words);

/// Parses a command line, which runs the callbacks of `app`. Returns nothing when the program should continue, else its
/// exit code: 0 after --help and --version, which it prints, 2 for a wrong command line, which it reports on stderr.
/// Adds --version to `app`. Throws the errors of the callbacks and of print(). Main thread.
std::optional<int> parse_command(CLI::App& app, int argc, char** argv);

}  // namespace mrroc::command
