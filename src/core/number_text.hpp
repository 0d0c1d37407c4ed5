#pragma once

#include <charconv>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// Numbers written by people in files and on the command line, the same in every locale. Pure functions; any thread.
namespace mrroc::core {

/// The double that is nearest to a decimal number: an optional sign `+` or `-`, digits with at most one point
/// (`1.`, `.5`), an optional exponent (`1e-3`, `1.E+3`); also `inf`, `infinity` and `nan` in any case. A number whose
/// magnitude is too small for a double gives 0. Nothing: the text contains anything else, blanks included, or the
/// magnitude is too large.
std::optional<double> to_double(std::string_view text) noexcept;

/// Whether `text` is a decimal number whose magnitude is too large for a double.
bool is_too_large(std::string_view text) noexcept;

/// Like `to_double`, but nothing for `inf` and `nan`.
std::optional<double> to_finite(std::string_view text) noexcept;

/// A whole number: an optional sign (`-` only for signed types) and decimal digits. Nothing: anything else, or it does
/// not fit the type.
template <class Whole>
std::optional<Whole> to_whole(std::string_view text) noexcept {
  if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
  Whole value{};
  const char* const end = text.data() + text.size();
  const auto [last, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc{} || last != end) return {};
  return value;
}

/// A whole number as C and CiA 306 write it: decimal, hexadecimal behind `0x` or `0X`, octal behind a leading `0`; an
/// optional sign. Nothing: anything else, or its magnitude needs more than 64 bits. A negative one is its
/// two's complement.
std::optional<std::uint64_t> to_literal(std::string_view text) noexcept;

/// The sixteen lower-case hexadecimal digits of `value`.
std::string hexadecimal(std::uint64_t value);
/// Two lower-case digits for each byte.
std::string hexadecimal(std::span<const std::byte> bytes);
/// The bytes of such a text, of digits in either case. Nothing: it is not one.
std::optional<std::vector<std::byte>> bytes_of_hexadecimal(std::string_view text);

/// Why `text` is not the number that was expected: "is empty", "has a decimal comma", "has U+00A0 at character 3", or
/// "is not a number". Only for texts that one of the functions above refused.
std::string number_problem(std::string_view text);

}  // namespace mrroc::core
