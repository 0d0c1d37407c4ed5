#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

namespace mrroc::cli::record {

/// A recording as the trace of the same run, to the last bit: what `mrroc run --trace` would have written.
struct TraceOfRecording {
  std::string text;       ///< with the first line
  bool complete = false;  ///< the run has closed the recording: it was not killed
};

/// Throws std::runtime_error when the file cannot be read, is not a recording, or a message is wrong.
TraceOfRecording trace_of(const std::filesystem::path& file);

/// Calls `write` with each message as one line of JSON: {"time":S,"topic":"/arm/steps","type":"...","message":{...}}.
/// Messages of topics that are not `wanted` are left out; empty: all are. Returns whether the recording is complete.
/// Throws as trace_of.
bool print_json(const std::filesystem::path& file, const std::function<void(std::string_view line)>& write,
                const std::function<bool(const std::string& topic)>& wanted = {});

}  // namespace mrroc::cli::record
