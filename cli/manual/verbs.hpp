#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace mrroc::cli {

/// One command of a command line: `mrroc`, `mrroc run`, `mrroc trace hash`.
struct Verb {
  std::string words;    ///< after the command's own name: "", "run", "trace hash"
  const CLI::App* app;  ///< its description; lives as long as the whole command's
};

/// Every verb of `app`, itself first, each before its own verbs; in the order in which they were described. Hidden
/// verbs (without a group) are omitted.
std::vector<Verb> verbs_of(const CLI::App& app);

/// The verbs directly below `app` that are not hidden.
std::vector<const CLI::App*> verbs_below(const CLI::App& app);

/// The options of `app` that begin with a dash and are not hidden.
std::vector<const CLI::Option*> dashed_options(const CLI::App& app);

/// The positional arguments of `app`.
std::vector<const CLI::Option*> positional_arguments(const CLI::App& app);

/// The values that `option` accepts when they are a list: real, paced, lockstep; else empty.
std::vector<std::string> choices_of(const CLI::Option& option);

}  // namespace mrroc::cli
