#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>

#include "sim/ur/program.hpp"

namespace mrroc::sim::ur {

/// The program of a single line of URScript with literal arguments, which a controller executes at once:
///
///   movej([...], a=..., v=...)   stopj(...)   stopl(...)
///   set_digital_out(i, ...)   digital_out[i]=...   set_analog_out(i, ...)   set_tcp   set_payload   set_tool_voltage
///
/// Null for any other line, and for one with too few numbers, an angle beyond a turn or a rate that is not above 0.
std::unique_ptr<Program> make_single_command(const std::string& line);

/// Sets the outputs that the line commands; analogue ones in V.
void set_outputs_of(const std::string& line, std::uint64_t& digital, std::array<double, 2>& analog);

}  // namespace mrroc::sim::ur
