// The decoder of each recorded message over any bytes: the first one chooses the message.
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "fuzz/fuzz.hpp"
#include "messages/cdr_reader.hpp"
#include "messages/message_table.hpp"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const auto types = mrroc::messages::message_types();
  const mrroc::messages::MessageType& type = types[data[0] % types.size()];
  const std::span<const std::byte> bytes = std::as_bytes(std::span(data + 1, size - 1));
  fuzz::refuses<mrroc::messages::CdrError>([&] {
    const std::vector<std::byte> again = type.recode(bytes);
    fuzz::require(type.recode(again) == again, "an encoding is decoded to the same message");
    // four bytes for each that a text or a sequence leaves out at most: its length, and alignment
    fuzz::require(again.size() <= 4 * size + 64, "a message is not larger than its bytes");
    const std::string text = type.json(bytes);
    fuzz::require(text.starts_with('{') && text.ends_with('}'), "a message is an object of JSON");
    fuzz::require(text.find('\n') == std::string::npos, "JSON is one line");
  });
  return 0;
}
