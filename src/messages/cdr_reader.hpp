#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "messages/cdr_writer.hpp"

namespace mrroc::messages {

/// The bytes are not the encoding of a message. `what()` names the byte, the value and what was expected.
class CdrError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Reads values in CDR (XCDR1) of either byte order, which the encapsulation header names. No length is believed before
/// the bytes for it are there: memory is at most proportional to the size of the input. Any thread; one at a time.
class CdrReader {
 public:
  /// The bytes must outlive the reader. Throws CdrError for an invalid header.
  explicit CdrReader(std::span<const std::byte> bytes);

  template <CdrNumber Value>
  Value number() {
    std::array<std::byte, sizeof(Value)> own;
    copy_number(own);
    if constexpr (std::same_as<Value, bool>) {
      check_boolean(own[0]);
      return own[0] == std::byte{1};
    } else {
      Value value;
      std::memcpy(&value, own.data(), sizeof(Value));
      return value;
    }
  }
  /// Throws CdrError for a text of more than `bound` bytes.
  std::string text(std::size_t bound = SIZE_MAX);
  /// The number of elements of a sequence, each of which has at least `smallest` bytes.
  std::size_t count(std::size_t smallest, std::size_t bound);
  /// Throws CdrError when more than the padding of the last value follows, up to 3 bytes.
  void end() const;

 private:
  /// The next bytes in the order of this machine.
  void copy_number(std::span<std::byte> into);
  void check_boolean(std::byte value) const;
  void require(std::size_t size, std::string_view what) const;

  std::span<const std::byte> bytes_;
  std::size_t position_ = 4;
  bool swapped_ = false;
};

/// Bytes of an encoding at least: of a message, a text, a number.
template <class Value>
constexpr std::size_t smallest() {
  if constexpr (CdrNumber<Value>)
    return sizeof(Value);
  else if constexpr (std::same_as<Value, std::string>)
    return 4;
  else
    return Value::kSmallest;
}

template <CdrNumber Value>
void decode(CdrReader& reader, Value& value) {
  value = reader.number<Value>();
}
inline void decode(CdrReader& reader, std::string& value) { value = reader.text(); }
inline void decode_text(CdrReader& reader, std::string& value, std::size_t bound) { value = reader.text(bound); }

template <class Value, std::size_t N>
void decode_array(CdrReader& reader, std::array<Value, N>& values) {
  for (Value& value : values) decode(reader, value);
}
template <class Value>
void decode_sequence(CdrReader& reader, std::vector<Value>& values, std::size_t bound = SIZE_MAX) {
  values.resize(reader.count(smallest<Value>(), bound));
  for (Value& value : values) decode(reader, value);
}

/// The message of an encoding. Throws CdrError.
template <class Message>
Message from_cdr(std::span<const std::byte> bytes) {
  CdrReader reader(bytes);
  Message message;
  decode(reader, message);
  reader.end();
  return message;
}

}  // namespace mrroc::messages
