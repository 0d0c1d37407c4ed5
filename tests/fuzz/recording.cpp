// The reader of recordings over a file of any content: as JSON, and as a trace with every rule of `mrroc trace check`.
#include <stdexcept>
#include <string>

#include "cli/record/recording_text.hpp"
#include "cli/trace/check.hpp"
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
    const std::string text = mrroc::cli::record::trace_of(path).text;
    fuzz::require(text.starts_with("# mrroc trace 2 clock="), "a trace has its first line");
    mrroc::cli::trace::check_trace(
        path, text, [](const std::string& violation) { fuzz::require(!violation.empty(), "a violation has a text"); });
  });
  return 0;
}
