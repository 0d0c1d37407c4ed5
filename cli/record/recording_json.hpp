#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

namespace mrroc::cli::record {

/// Calls `write` with each message as one line of JSON: {"time":S,"topic":"/arm/steps","type":"...","message":{...}}.
/// Messages of topics that are not `wanted` are left out; empty: all are. Returns whether the recording is complete.
/// Throws std::runtime_error when the file cannot be read, is not a recording, or a message is wrong.
bool print_json(const std::filesystem::path& file, const std::function<void(std::string_view line)>& write,
                const std::function<bool(const std::string& topic)>& wanted = {});

}  // namespace mrroc::cli::record
