#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace mrroc::cli {

/// The manual page of section 1 in troff (man(7) macros) of the command that `app` describes: name, synopsis, each verb
/// with its arguments and options, exit codes. `version` is in the footer. The same description gives the same text.
std::string manual_page(const CLI::App& app, const std::string& version);

}  // namespace mrroc::cli
