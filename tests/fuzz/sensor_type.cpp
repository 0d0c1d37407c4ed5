// The declarations of sensors/<type>/<type>.toml, then the line "====", then the keys of a sensor of the type in a
// deployment.
#include "config/entries/sensor_type.hpp"

#include <stdlib.h>

#include <cmath>

#include "fuzz/fuzz.hpp"
#include "fuzz/memory_file.hpp"
#include "mrroc/testing/scratch_folder.hpp"

namespace {

/// A share folder with one sensor type, "any".
struct Share {
  Share() {
    folder.write(kFile, "");
    setenv("MRROC_SHARE", folder.path().c_str(), 1);
  }
  mrroc::task_test::ScratchFolder folder;
  fuzz::MemoryFile keys;
  static constexpr const char* kFile = "sensors/any/any.toml";
};

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const Share share;
  fuzz::Bytes input(data, size);
  share.folder.write(Share::kFile, input.take_section());
  fuzz::refuses<mrroc::config::ConfigurationError>([&] {
    mrroc::config::SensorEntry sensor;
    sensor.type = "any";
    mrroc::config::read_sensor_type(mrroc::config::Table::load(share.keys.write(input.rest())), sensor);
    fuzz::require(!sensor.sources.empty(), "a type has a source");
    for (const auto& [key, numbers] : sensor.numbers)
      for (const double number : numbers) fuzz::require(std::isfinite(number), "a parameter is a finite number");
  });
  return 0;
}
