#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace mrroc::cli {

/// A static bash completion of the command that `app` describes: verbs, options, values of options that have a list of
/// them, else file names. It starts no process. The same description gives the same text.
std::string bash_completion(const CLI::App& app);

}  // namespace mrroc::cli
