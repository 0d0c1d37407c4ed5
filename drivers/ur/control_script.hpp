#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "drivers/ur/options.hpp"

namespace mrroc::ur {

/// The first line of the control script; its number changes when the meaning of a register does.
inline constexpr std::string_view kScriptHeader = "# mrroc_control 1";

/// Reads the control script's file: `options.script`, else the installed drivers/ur/control.script. Throws
/// std::runtime_error that names the file.
std::string read_control_script(const UrOptions& options);

/// The program for one controller: `script` with its words between two @ replaced. `program` is reported in an output
/// register; `frequency` (Hz) of the controller converts the watchdog's time. Throws std::runtime_error that names a
/// word without a value.
std::string control_program(const std::string& script, const UrOptions& options, double frequency,
                            std::int32_t program);

/// Sends the program to the controller's secondary interface, which starts it in place of a running one. Throws
/// ConnectionError. The interface does not confirm it: the program's state does.
void upload_program(const std::string& program, const UrOptions& options);

}  // namespace mrroc::ur
