#include "config/text/toml_text.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>

namespace mrroc::config::toml_text_test {
namespace {

TEST(TomlText, KeysAndValuesMayHaveAnyCharacters) {
  for (const std::string text : {"plain", "", "a b", "a\"b", "a\\b", "a'b", "a\nb", "a\rb", "a\tb", "a\x01 b",
                                 "a\x7f b", "\xc3\xa9", "a.b", "[a]", "'''\n\"\"\""}) {
    toml::table inner{{text, text}};
    inner.insert("list", toml::array{text, toml::table{{text, text}}});
    const toml::table root{{text, inner}, {"value", text}};
    EXPECT_EQ(toml::parse(toml_text(root)), root) << toml_text(root);
  }
}

TEST(TomlText, KeysStandInTheOrderOfTheFile) {
  EXPECT_EQ(toml_text(toml::parse("b = 1\na = 0.5\nl = [{ y = 1, x = 2 }, 'q']\n[z]\ny = true\n[z.c]\n[d]\n")),
            "\"b\" = 1\n\"a\" = 0.5\n\"l\" = [{\"y\" = 1, \"x\" = 2}, \"q\"]\n[\"z\"]\n\"y\" = "
            "true\n[\"z\".\"c\"]\n[\"d\"]\n");
}

RC_GTEST_PROP(TomlText, NumbersAreReadAsTheyAreWritten, (const std::vector<std::int64_t>& whole, std::uint64_t bits)) {
  const auto number = std::bit_cast<double>(bits);
  RC_PRE(std::isfinite(number));
  toml::table root{{"number", number}};
  toml::array list;
  for (const std::int64_t value : whole) list.push_back(value);
  root.insert("list", std::move(list));
  RC_ASSERT(toml::parse(toml_text(root)) == root);
}

}  // namespace
}  // namespace mrroc::config::toml_text_test
