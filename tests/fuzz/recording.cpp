// The reader of recordings over a file of any content: as JSON, and with every rule of `mrroc trace check`, and hashed.
#include <stdexcept>
#include <string>

#include "cli/record/recording_json.hpp"
#include "cli/trace/check.hpp"
#include "cli/trace/hash.hpp"
#include "fuzz/fuzz.hpp"
#include "fuzz/memory_file.hpp"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const fuzz::MemoryFile file;
  const std::filesystem::path path = file.write(fuzz::text_of(data, size));
  fuzz::refuses<std::runtime_error>([&] {
    mrroc::cli::record::print_json(path, [](std::string_view line) {
      fuzz::require(line.starts_with("{\"time\":"), "a message has a time");
      fuzz::require(line.find('\n') == std::string_view::npos, "a message is one line");
    });
  });
  fuzz::refuses<std::runtime_error>([&] {
    std::size_t reports = 0;
    const auto verdict = mrroc::cli::trace::check_trace(path, [&reports](const std::string& violation) {
      fuzz::require(!violation.empty(), "a violation has a text");
      ++reports;
    });
    fuzz::require(verdict.violations >= reports, "every reported violation is counted");
  });
  fuzz::refuses<std::runtime_error>(
      [&] { fuzz::require(mrroc::cli::trace::hash_of(path).text.size() == 16, "a hash has 16 digits"); });
  return 0;
}
