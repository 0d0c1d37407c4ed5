#include "messages/cdr_reader.hpp"

#include <algorithm>

namespace mrroc::messages {

namespace {

constexpr std::size_t kHeaderSize = 4;
constexpr std::size_t kPadding = 3;

}  // namespace

CdrReader::CdrReader(std::span<const std::byte> bytes) : bytes_(bytes) {
  if (bytes.size() < kHeaderSize)
    throw CdrError("CDR of " + std::to_string(bytes.size()) + " bytes, expected a header of 4");
  const auto kind = std::to_integer<unsigned>(bytes[0]) << 8U | std::to_integer<unsigned>(bytes[1]);
  if (kind > 1)
    throw CdrError("CDR: encapsulation " + std::to_string(kind) + ", expected 0 (big-endian) or 1 (little-endian)");
  swapped_ = kind == 0;
}

void CdrReader::copy_number(std::span<std::byte> into) {
  // no sum overflows: the position is at most the size
  position_ += (into.size() - (position_ - kHeaderSize) % into.size()) % into.size();
  require(into.size(), "a number");
  const std::span<const std::byte> own = bytes_.subspan(position_, into.size());
  if (swapped_)
    std::reverse_copy(own.begin(), own.end(), into.begin());
  else
    std::copy(own.begin(), own.end(), into.begin());
  position_ += into.size();
}

std::string CdrReader::text(std::size_t bound) {
  const std::size_t size = number<std::uint32_t>();
  if (size == 0) return {};  // some writers leave out the final zero of an empty text
  require(size, "a text");
  const std::span<const std::byte> own = bytes_.subspan(position_, size);
  if (own.back() != std::byte{0})
    throw CdrError("CDR: byte " + std::to_string(position_ + size - 1) + " is " +
                   std::to_string(std::to_integer<unsigned>(own.back())) + ", expected 0 at the end of a text");
  if (size - 1 > bound)
    throw CdrError("CDR: a text of " + std::to_string(size - 1) + " bytes at byte " + std::to_string(position_) +
                   ", expected at most " + std::to_string(bound) + " bytes");
  std::string text(size - 1, '\0');
  std::transform(own.begin(), own.end() - 1, text.begin(),
                 [](std::byte byte) { return static_cast<char>(std::to_integer<unsigned char>(byte)); });
  position_ += size;
  return text;
}

std::size_t CdrReader::count(std::size_t smallest, std::size_t bound) {
  const std::size_t count = number<std::uint32_t>();
  if (count > bound)
    throw CdrError("CDR: " + std::to_string(count) + " elements before byte " + std::to_string(position_) +
                   ", expected at most " + std::to_string(bound));
  if (count != 0) require(count * smallest, "a sequence");
  return count;
}

void CdrReader::end() const {
  if (position_ + kPadding < bytes_.size())
    throw CdrError("CDR: " + std::to_string(bytes_.size() - position_) +
                   " bytes follow the message, expected at most " + std::to_string(kPadding));
}

void CdrReader::check_boolean(std::byte value) const {
  if (value > std::byte{1})
    throw CdrError("CDR: byte " + std::to_string(position_ - 1) + " is " +
                   std::to_string(std::to_integer<unsigned>(value)) + ", expected 0 or 1");
}

void CdrReader::require(std::size_t size, std::string_view what) const {
  if (position_ <= bytes_.size() && size <= bytes_.size() - position_) return;
  throw CdrError("CDR: " + std::string{what} + " of " + std::to_string(size) + " bytes at byte " +
                 std::to_string(position_) + ", expected at most " +
                 std::to_string(bytes_.size() - std::min(position_, bytes_.size())) + " bytes");
}

}  // namespace mrroc::messages
