#pragma once

#include <gtest/gtest.h>

#include <string>

namespace mrroc::test {

/// Puts `to` in the place of the first `from`, which `text` contains.
inline void replace(std::string& text, const std::string& from, const std::string& to) {
  const std::size_t place = text.find(from);
  ASSERT_NE(place, std::string::npos) << from;
  text.replace(place, from.size(), to);
}

}  // namespace mrroc::test
