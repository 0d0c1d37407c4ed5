#include "config/table.hpp"

#include <gtest/gtest.h>

#include <clocale>
#include <locale>

#include "config/message_of.hpp"
#include "mrroc/testing/scratch_folder.hpp"

namespace mrroc::config::table_test {
namespace {

using std::string;
using std::vector;

constexpr std::string_view kText = R"(# line 1
name = "press"
period = 0.002
count = 3
ready = true
when = 2024-05-01
home = [0, 0.5,
        -1]
mixed = [1, "two"]

[robots.zeta]
type = "irb6"
[robots.alpha]
type = "conveyor"

[[axes]]
name = "column"

[[axes]]
name = "arm"
)";

class TableTest : public testing::Test {
 protected:
  Table load(std::string_view text = kText) { return Table::load(scratch_.write("t.toml", text)); }

  /// Message of the error that `action(table)` throws, without the folder.
  template <typename Action>
  string message(Action action, std::string_view text = kText) {
    return message_of(scratch_.path(), [&] { action(load(text)); });
  }

  task_test::ScratchFolder scratch_;
};

TEST_F(TableTest, ReadsEveryTypeOfValue) {
  const Table table = load();
  EXPECT_EQ(table.text("name"), "press");
  EXPECT_EQ(table.optional_text("name"), "press");
  EXPECT_EQ(table.optional_text("nothing"), std::nullopt);
  EXPECT_EQ(table.choice("name", {"weld", "press"}), "press");
  EXPECT_EQ(table.number("period"), 0.002);
  EXPECT_EQ(table.number("count"), 3.0);
  EXPECT_EQ(table.number_or("nothing", 7.5), 7.5);
  EXPECT_EQ(table.number_or("period", 7.5), 0.002);
  EXPECT_EQ(table.integer("count", 3, 3), 3);
  EXPECT_EQ(table.integer_or("nothing", 9, 0, 3), 9);
  EXPECT_EQ(table.integer_or("count", 9, 0, 3), 3);
  EXPECT_TRUE(table.boolean_or("ready", false));
  EXPECT_TRUE(table.boolean_or("nothing", true));
  EXPECT_EQ(table.numbers("home"), (vector<double>{0, 0.5, -1}));
  EXPECT_EQ(table.numbers("home", 3, {-1, 1}), (vector<double>{0, 0.5, -1}));
  EXPECT_EQ(table.optional_numbers("nothing", 3), std::nullopt);
  EXPECT_TRUE(table.has("when"));
  EXPECT_FALSE(table.has("nothing"));
}

TEST_F(TableTest, GivesKeysAndTablesInFileOrder) {
  const Table table = load();
  EXPECT_EQ(table.keys(),
            (vector<string>{"name", "period", "count", "ready", "when", "home", "mixed", "robots", "axes"}));
  EXPECT_EQ(table.table("robots").table_names(), (vector<string>{"zeta", "alpha"}));
  EXPECT_EQ(table.table("robots").table("alpha").text("type"), "conveyor");
  ASSERT_EQ(table.tables("axes").size(), 2u);
  EXPECT_EQ(table.tables("axes")[1].text("name"), "arm");
  EXPECT_TRUE(table.tables("nothing").empty());
  EXPECT_FALSE(table.optional_table("nothing"));
  EXPECT_EQ(table.optional_table("robots")->line("zeta"), 11);
}

TEST_F(TableTest, HasItsLineAndKey) {
  const Table table = load();
  EXPECT_EQ(table.file(), scratch_.path() / "t.toml");
  EXPECT_EQ(table.line(), 1);
  EXPECT_EQ(table.line("count"), 4);
  EXPECT_EQ(table.table("robots").table("alpha").line(), 13);
  EXPECT_EQ(table.table("robots").table("alpha").line("type"), 14);
  EXPECT_EQ(table.tables("axes")[1].line(), 19);
}

TEST_F(TableTest, NamesTheError) {
  const auto refused = [this](auto getter) { return message(getter); };
  EXPECT_EQ(refused([](Table t) { t.text("nothing"); }), "t.toml:1: nothing: missing, expected a text");
  EXPECT_EQ(refused([](Table t) { t.text("count"); }), "t.toml:4: count: 3 is an integer, expected a text");
  EXPECT_EQ(refused([](Table t) { t.optional_text("ready"); }), "t.toml:5: ready: true is a boolean, expected a text");
  EXPECT_EQ(refused([](Table t) { t.text("when"); }), "t.toml:6: when: is a date or a time, expected a text");
  EXPECT_EQ(refused([](Table t) {
              t.choice("name", {"weld", "pick", "sort"});
            }),
            "t.toml:2: name: unknown value 'press', expected 'weld', 'pick' or 'sort'");
  EXPECT_EQ(refused([](Table t) { t.choice("count", {"weld"}); }), "t.toml:4: count: 3 is an integer, expected 'weld'");
  EXPECT_EQ(refused([](Table t) { t.number("name"); }), "t.toml:2: name: 'press' is a text, expected a number");
  EXPECT_EQ(refused([](Table t) { t.number("ready"); }), "t.toml:5: ready: true is a boolean, expected a number");
  EXPECT_EQ(refused([](Table t) {
              t.number("period", {0.01, 1});
            }),
            "t.toml:3: period: 0.002 is out of range, expected a number from 0.01 to 1");
  EXPECT_EQ(refused([](Table t) { t.number_or("period", 1, {.max = 1e-9}); }),
            "t.toml:3: period: 0.002 is out of range, expected a number of at most 1e-09");
  EXPECT_EQ(refused([](Table t) { t.integer("period", 0, 5); }),
            "t.toml:3: period: 0.002 is a number, expected an integer from 0 to 5");
  EXPECT_EQ(refused([](Table t) { t.integer_or("count", 1, 4, 5); }),
            "t.toml:4: count: 3 is out of range, expected an integer from 4 to 5");
  EXPECT_EQ(refused([](Table t) { t.boolean_or("name", true); }),
            "t.toml:2: name: 'press' is a text, expected true or false");
  EXPECT_EQ(refused([](Table t) { t.numbers("home", 2); }),
            "t.toml:7: home: has 3 values, expected an array of 2 numbers");
  EXPECT_EQ(refused([](Table t) { t.numbers("home", 3, {.min = 0}); }),
            "t.toml:8: home[2]: -1 is out of range, expected a number of at least 0");
  EXPECT_EQ(refused([](Table t) { t.numbers("mixed"); }), "t.toml:9: mixed[1]: 'two' is a text, expected a number");
  EXPECT_EQ(refused([](Table t) { t.optional_numbers("name"); }),
            "t.toml:2: name: 'press' is a text, expected an array of numbers");
  EXPECT_EQ(refused([](Table t) { t.table("name"); }), "t.toml:2: name: 'press' is a text, expected a table [name]");
  EXPECT_EQ(refused([](Table t) { t.table("robots").table("beta"); }),
            "t.toml:11: robots.beta: missing, expected a table [robots.beta]");
  EXPECT_EQ(refused([](Table t) { t.table_names(); }), "t.toml:2: name: 'press' is a text, expected a table [name]");
  EXPECT_EQ(refused([](Table t) { t.tables("robots"); }), "t.toml:11: robots: is a table, expected tables [[robots]]");
  EXPECT_EQ(refused([](Table t) { t.tables("home"); }), "t.toml:7: home[0]: 0 is an integer, expected tables [[home]]");
  EXPECT_EQ(refused([](Table t) { t.tables("axes")[1].text("nam"); }),
            "t.toml:20: axes[1].name: unknown key, did you mean 'nam'?");
  EXPECT_EQ(refused([](Table t) { t.tables("axes")[1].number("name"); }),
            "t.toml:20: axes[1].name: 'arm' is a text, expected a number");
}

TEST_F(TableTest, RefusesNumbersThatAreNotFinite) {
  for (const string value : {"inf", "-inf", "nan"}) {
    EXPECT_EQ(message([](Table t) { t.number("a"); }, "a = " + value),
              "t.toml:1: a: " + value + " is not finite, expected a number");
    EXPECT_EQ(message([](Table t) { t.numbers("a"); }, "a = [" + value + "]"),
              "t.toml:1: a[0]: " + value + " is not finite, expected a number");
  }
}

TEST_F(TableTest, FailNamesTheTableOrItsKey) {
  EXPECT_EQ(message([](Table t) { t.table("robots").table("zeta").fail("type", "no such", "one"); }),
            "t.toml:12: robots.zeta.type: no such, expected one");
  EXPECT_EQ(message([](Table t) { t.table("robots").table("zeta").fail("", "no such", "one"); }),
            "t.toml:11: robots.zeta: no such, expected one");
  EXPECT_EQ(message([](Table t) { t.fail("", "no such", "one"); }), "t.toml:1: no such, expected one");
}

TEST_F(TableTest, FinishRefusesUnusedKeys) {
  const auto read = [](Table t) {
    t.number_or("rate", 0);
    t.text("name");
    t.table("sub");
    t.finish();
  };
  EXPECT_EQ(message(read, "name = 'a'\n[sub]\nfree = 1"), "");
  EXPECT_EQ(message(read, "name = 'a'\nraet = 1\n[sub]"), "t.toml:2: raet: unknown key, did you mean 'rate'?");
  EXPECT_EQ(message(read, "name = 'a'\n'od d' = 1\n[sub]"),
            "t.toml:2: 'od d': unknown key, expected 'name', 'rate' or 'sub'");
  EXPECT_EQ(message([](Table t) { t.table("sub").finish(); }, "[sub]\na = 1"),
            "t.toml:2: sub.a: unknown key, expected no keys here");
}

TEST_F(TableTest, OnlyRefusesUnknownKeysBeforeTheyAreRead) {
  const auto read = [](Table t) { t.only({"mode", "rate"}); };
  EXPECT_EQ(message(read, "rate = 'any'"), "");
  EXPECT_EQ(message(read, "rate = 1\nmoed = 1"), "t.toml:2: moed: unknown key, did you mean 'mode'?");
}

TEST_F(TableTest, MisspeltRequiredKeyIsReportedAtItsLine) {
  const auto read = [](Table t) { t.number("regulator_b0"); };
  EXPECT_EQ(message(read, "\nregulatro_b0 = 1"), "t.toml:2: regulatro_b0: unknown key, did you mean 'regulator_b0'?");
  EXPECT_EQ(message(read, "\nregulator_b1 = 1"), "t.toml:1: regulator_b0: missing, expected a number");
}

TEST_F(TableTest, CopiesShareTheRecordOfUsedKeys) {
  const Table table = load("a = 1\nb = 2");
  const Table copy = table;
  table.number("a");
  copy.number("b");
  EXPECT_NO_THROW(table.finish());
  EXPECT_NO_THROW(copy.finish());
}

/// German numbers: 1.234,5.
struct CommaNumbers : std::numpunct<char> {
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\3"; }
};

TEST_F(TableTest, ReadsAndWritesNumbersEquallyInEveryLocale) {
  const std::locale before = std::locale::global(std::locale(std::locale::classic(), new CommaNumbers));
  std::setlocale(LC_ALL, "de_DE.UTF-8");  // the C library's own too, where it is installed
  EXPECT_EQ(load("a = 1_234.5").number("a"), 1234.5);
  EXPECT_EQ(message(
                [](Table t) {
                  t.number("a", {0.25, 1e4});
                },
                "a = 12345.5"),
            "t.toml:1: a: 12345.5 is out of range, expected a number from 0.25 to 10000");
  EXPECT_EQ(message([](Table t) { t.integer("a", 0, 1000); }, "a = 12345"),
            "t.toml:1: a: 12345 is out of range, expected an integer from 0 to 1000");
  EXPECT_EQ(message([](Table t) { t.text("a"); }, std::string(1200, '\n') + "a = 1"),
            "t.toml:1201: a: 1 is an integer, expected a text");
  std::locale::global(before);
  std::setlocale(LC_ALL, "C");
}

}  // namespace
}  // namespace mrroc::config::table_test
