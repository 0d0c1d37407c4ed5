// A file of letters for the engraver, of any content, and the strokes of a text with them.
#include "engraving/lettering.hpp"

#include <cmath>

#include "config/table.hpp"
#include "fuzz/fuzz.hpp"
#include "fuzz/memory_file.hpp"
#include "mrroc/errors.hpp"

namespace {

constexpr double kRounding = 1e-9;

void write(const engraving::Lettering& letters) {
  const Eigen::Vector2d size(1, 0.5);
  for (const auto& stroke : letters.strokes("A AB", size, 0.1, 0.01)) {
    for (const auto& piece : stroke)
      for (const auto& point : piece)
        fuzz::require(((2 * point).cwiseAbs().array() <= size.array() + kRounding).all(), "a letter is on the board");
  }
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const fuzz::MemoryFile file;
  fuzz::refuses<mrroc::config::ConfigurationError>([&] {
    const engraving::Lettering letters(file.write(fuzz::text_of(data, size)));
    fuzz::refuses<mrroc::NonFatalError>([&] { write(letters); });
  });
  return 0;
}
