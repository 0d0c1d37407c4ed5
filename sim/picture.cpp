#include "sim/picture.hpp"

#include <png.h>

#include "mrroc/errors.hpp"

namespace mrroc::sim {

void write_png(const std::filesystem::path& file, const Picture& picture) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<png_uint_32>(picture.width);
  image.height = static_cast<png_uint_32>(picture.height);
  image.format = PNG_FORMAT_RGB;
  if (png_image_write_to_file(&image, file.c_str(), 0, picture.pixels.data(), 0, nullptr) == 0) {
    throw SystemError(ErrorCode::resources, "cannot write " + file.string() + ": " + image.message);
  }
}

}  // namespace mrroc::sim
