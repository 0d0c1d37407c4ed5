#pragma once

#include <string>
#include <string_view>

namespace mrroc::command {

/// The version of MRROC++ that a program is linked with: "0.2.0", CMake's project version.
std::string_view version() noexcept;

/// What a program prints for --version: "mrroc 0.2.0" for the command itself, "irb6_edp (MRROC++) 0.2.0" for another.
std::string version_text(std::string_view program);

}  // namespace mrroc::command
