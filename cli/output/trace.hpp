#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "config/deployment.hpp"
#include "process/record/trace_header.hpp"

namespace mrroc::cli {

using process::kTraceHeader;

/// Joins the traces of several processes into one, ordered by tick, then process, then as each process wrote them: the
/// order depends on the lines alone. (The tick of a line is here the newest of its process so far: a `Wait` without
/// robots may have older ticks than the line before.) `clock`: the clock of the processes. Calls `write` for each piece
/// of text. Throws std::runtime_error when a part cannot be read, and any exception of `write`.
void merge_traces(const std::vector<std::filesystem::path>& parts, config::ClockMode clock,
                  const std::function<void(std::string_view text)>& write);

/// The same of lines in memory, by process, without a first line and without line ends: the joined text. Any thread.
std::string merge_lines(const std::map<std::string, std::vector<std::string_view>>& processes);

/// FNV-1a (64 bit) of all lines below the first, as 16 hexadecimal digits. Throws std::runtime_error when the file
/// cannot be read or is not a trace.
std::string hash_trace(const std::filesystem::path& trace);
/// The same of a trace in memory; `name`: of its file in messages.
std::string hash_trace(const std::filesystem::path& name, const std::string& text);

}  // namespace mrroc::cli
