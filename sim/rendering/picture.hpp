#pragma once

#include <cstddef>
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

/// The bytes of a PNG file. Throws SystemError (resources).
std::vector<std::byte> encode_png(const Picture& picture);

/// Throws std::runtime_error when the file holds something else than a picture, SystemError (resources) when it cannot
/// be written.
void write_png(const std::filesystem::path& file, const Picture& picture);

}  // namespace mrroc::sim
