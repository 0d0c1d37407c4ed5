#pragma once

#include <string>
#include <string_view>

namespace mrroc::command {

/// The version of MRROC++ with which a program is linked: "0.2.0", CMake's project version.
std::string_view version() noexcept;

/// The output of a program for --version: "mrroc 0.2.0" for the command itself, "irb6_edp (MRROC++) 0.2.0" for another.
std::string version_text(std::string_view program);

}  // namespace mrroc::command
