// The trace reader, and every rule of `mrroc trace check`, over a file of any content.
#include <stdexcept>
#include <string>

#include "cli/trace/check.hpp"
#include "fuzz/fuzz.hpp"
#include "fuzz/memory_file.hpp"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const fuzz::MemoryFile file;
  std::size_t reports = 0;
  fuzz::refuses<std::runtime_error>([&] {
    const auto verdict =
        mrroc::cli::trace::check_trace(file.write(fuzz::text_of(data, size)), [&](const std::string& text) {
          fuzz::require(!text.empty(), "a violation has a text");
          ++reports;
        });
    fuzz::require(verdict.violations >= reports, "every reported violation is counted");
  });
  return 0;
}
