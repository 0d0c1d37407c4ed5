#include "sim/rendering/picture.hpp"

#include <png.h>

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "command/replaceable.hpp"
#include "command/write_file.hpp"
#include "mrroc/errors.hpp"

namespace mrroc::sim {

std::vector<std::byte> encode_png(const Picture& picture) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<png_uint_32>(picture.width);
  image.height = static_cast<png_uint_32>(picture.height);
  image.format = PNG_FORMAT_RGB;
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(image);  // a bound: it is encoded once
  std::vector<std::byte> bytes(size);
  if (png_image_write_to_memory(&image, bytes.data(), &size, 0, picture.pixels.data(), 0, nullptr) == 0)
    throw SystemError(ErrorCode::resources, std::string("cannot encode a picture: ") + image.message);
  bytes.resize(size);
  return bytes;
}

void write_png(const std::filesystem::path& file, const Picture& picture) {
  constexpr std::string_view kSignature = "\x89PNG\r\n\x1a\n";
  command::check_replaceable(file, kSignature, "the picture", "a picture");
  // encoded in memory: libpng would remove an unwritable output file, even a device
  command::write_file(file, encode_png(picture));
}

}  // namespace mrroc::sim
