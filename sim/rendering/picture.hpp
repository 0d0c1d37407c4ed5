#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

namespace mrroc::sim {

/// 8-bit RGB, rows from top to bottom: 3 * width * height bytes.
struct Picture {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> pixels;
};

/// Throws SystemError (resources) when the file cannot be written.
void write_png(const std::filesystem::path& file, const Picture& picture);

}  // namespace mrroc::sim
