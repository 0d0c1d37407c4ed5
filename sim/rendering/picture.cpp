#include "sim/rendering/picture.hpp"

#include <png.h>

#include <cstddef>
#include <span>
#include <vector>

#include "command/write_file.hpp"
#include "mrroc/errors.hpp"

namespace mrroc::sim {

void write_png(const std::filesystem::path& file, const Picture& picture) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<png_uint_32>(picture.width);
  image.height = static_cast<png_uint_32>(picture.height);
  image.format = PNG_FORMAT_RGB;
  // encode in memory: libpng would remove an unwritable output file, even a device
  png_alloc_size_t size = 0;
  std::vector<std::byte> bytes;
  for (bool measured = false;; measured = true) {
    bytes.resize(size);
    void* const memory = measured ? bytes.data() : nullptr;
    if (png_image_write_to_memory(&image, memory, &size, 0, picture.pixels.data(), 0, nullptr) == 0)
      throw SystemError(ErrorCode::resources, "cannot encode " + file.string() + ": " + image.message);
    if (measured) break;
  }
  command::write_file(file, std::span(bytes).first(size));
}

}  // namespace mrroc::sim
