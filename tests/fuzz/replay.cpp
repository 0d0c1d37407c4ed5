// Sensor readings replayed from a file (vsp/replay_source.hpp), of any content.
#include "config/table.hpp"
#include "fuzz/fuzz.hpp"
#include "fuzz/memory_file.hpp"
#include "vsp/replay_source.hpp"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const fuzz::MemoryFile file;
  static const std::vector<mrroc::vsp::Channel> channels{{"a", "m"}, {"b", "N"}};
  fuzz::refuses<mrroc::config::ConfigurationError>([&] {
    mrroc::vsp::ReplaySource source(file.write(fuzz::text_of(data, size)), channels);
    bool was_ready = false;
    for (const mrroc::Tick tick : {mrroc::Tick{0}, mrroc::Tick{1}, mrroc::Tick{250}, mrroc::kNever - 1}) {
      mrroc::vsp::RawReading raw;
      const bool ready = source.read(tick, raw) == mrroc::vsp::SourceState::ready;
      fuzz::require(!ready || (raw.tick == tick && raw.count == channels.size()),
                    "a reading belongs to the requested tick");
      fuzz::require(ready || !was_ready, "the last line applies to all later ticks");
      was_ready = ready;
    }
    fuzz::require(was_ready, "an accepted file has a reading");
  });
  return 0;
}
