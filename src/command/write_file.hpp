#pragma once

#include <cstddef>
#include <filesystem>
#include <span>

namespace mrroc::command {

/// Makes `bytes` the content of `file`, which may also be a FIFO or a device. Throws SystemError(resources) that names
/// the file and the system's reason when any of it cannot be written: a full disk, a quota, a file size limit.
void write_file(const std::filesystem::path& file, std::span<const std::byte> bytes);

}  // namespace mrroc::command
