#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace mrroc::cli {

/// An empty file in the trace's place. Throws std::runtime_error when it cannot be written.
void create_trace(const std::filesystem::path& trace);

/// Joins the traces of several processes into one, ordered by tick, then process, then as each process wrote them: an
/// order that depends on nothing but the lines. Throws std::runtime_error when a file cannot be read or written.
void merge_traces(const std::vector<std::filesystem::path>& parts, const std::filesystem::path& merged);

/// FNV-1a (64 bit) of all lines below the first, as 16 hexadecimal digits. Throws std::runtime_error when it cannot be
/// read, or is no trace.
std::string hash_trace(const std::filesystem::path& trace);

}  // namespace mrroc::cli
