#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace mrroc::command {

/// Whether the file may be replaced by one that begins with `beginning`, because nothing else would be lost: it does
/// not exist, is empty, begins in the same way, or is no regular file.
bool is_replaceable(const std::filesystem::path& file, std::string_view beginning);

/// Throws std::runtime_error unless it may: "`what` FILE: holds something else, expected a new file, or `kind` to
/// replace".
void check_replaceable(const std::filesystem::path& file, std::string_view beginning, const std::string& what,
                       const std::string& kind);

}  // namespace mrroc::command
