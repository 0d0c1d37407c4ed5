#pragma once

#include <array>
#include <bit>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <vector>

namespace mrroc::messages {

/// A fixed-size value of CDR: a boolean, an integer or a floating-point number.
template <class Value>
concept CdrNumber = std::integral<Value> || std::floating_point<Value>;

/// Appends values in CDR (XCDR1, the encoding of ROS 2): little-endian, each aligned to its size from the end of the
/// 4-byte encapsulation header. Any thread; one at a time.
class CdrWriter {
  static_assert(std::endian::native == std::endian::little, "the bytes of a number are copied");

 public:
  /// Begins with the header.
  CdrWriter() : bytes_{kHeader.begin(), kHeader.end()} {}

  template <CdrNumber Value>
  void number(Value value) {
    while ((bytes_.size() - kHeader.size()) % sizeof(Value) != 0) bytes_.push_back(std::byte{0});
    std::array<std::byte, sizeof(Value)> own;
    std::memcpy(own.data(), &value, sizeof(Value));
    bytes_.insert(bytes_.end(), own.begin(), own.end());
  }
  /// Its length with the final zero, its characters, the zero.
  void text(const std::string& text) {
    number(static_cast<std::uint32_t>(text.size() + 1));
    const std::span<const std::byte> own = std::as_bytes(std::span(text));
    bytes_.insert(bytes_.end(), own.begin(), own.end());
    bytes_.push_back(std::byte{0});
  }
  /// The encoding. Ends the use of this object.
  std::vector<std::byte> take() { return std::move(bytes_); }

 private:
  static constexpr std::array<std::byte, 4> kHeader{std::byte{0}, std::byte{1}, std::byte{0}, std::byte{0}};
  std::vector<std::byte> bytes_;
};

template <CdrNumber Value>
void encode(CdrWriter& writer, Value value) {
  writer.number(value);
}
inline void encode(CdrWriter& writer, const std::string& value) { writer.text(value); }
/// At most the first `bound` bytes of the text.
inline void encode_text(CdrWriter& writer, const std::string& value, std::size_t bound) {
  writer.text(value.substr(0, bound));
}

template <class Value, std::size_t N>
void encode_array(CdrWriter& writer, const std::array<Value, N>& values) {
  for (const Value& value : values) encode(writer, value);
}
/// The number of elements, then the elements. With a bound, those up to the bound.
template <class Value>
void encode_sequence(CdrWriter& writer, const std::vector<Value>& values, std::size_t bound = SIZE_MAX) {
  const std::size_t count = std::min(values.size(), bound);
  writer.number(static_cast<std::uint32_t>(count));
  for (std::size_t i = 0; i < count; ++i) encode(writer, values[i]);
}

/// The encoding of a message.
template <class Message>
std::vector<std::byte> to_cdr(const Message& message) {
  CdrWriter writer;
  encode(writer, message);
  return writer.take();
}

}  // namespace mrroc::messages
