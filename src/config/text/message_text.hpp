#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "config/table.hpp"

/// Text for the messages of configuration errors. The same in every locale.
namespace mrroc::config {

/// Shortest text that reads back as the same number: 0.002, 1e-09, inf.
std::string number_text(double value);

/// `'text'` on one line, as core::shown writes it; a long text is cut at 60 bytes with `...`.
std::string in_quotes(std::string_view text);

/// `'a', 'b' or 'c'`, in the order given; "nothing" for an empty list.
std::string alternatives(const std::vector<std::string>& choices);

/// "a number from 0 to 1", "a number of at least 0", "a number of at most 1", "a number".
std::string expected_number(Range range);

/// "an integer from 0 to 230", with the open ends of `expected_number`.
std::string expected_integer(std::int64_t min, std::int64_t max);

}  // namespace mrroc::config
