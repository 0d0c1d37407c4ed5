#include "vsp/replay_source.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>
#include <cstdio>
#include <string>

#include "config/message_of.hpp"
#include "mrroc/testing/scratch_folder.hpp"

namespace mrroc::vsp::replay_source_test {
namespace {

const std::vector<Channel> kTwo{{"a", "m"}, {"b", "N"}};

TEST(ReplaySource, HoldsEachLineUntilTheNext) {
  const task_test::ScratchFolder scratch;
  ReplaySource source(scratch.write("r.txt",
                                    "# mrroc readings a b\r\n"
                                    "# a comment, then an empty line\n"
                                    "\n"
                                    "10 1.25\t-2e-3\r\n"
                                    "  20   3 nan  "),
                      kTwo);
  RawReading raw;
  EXPECT_EQ(source.read(0, raw), SourceState::not_ready);
  EXPECT_EQ(source.read(9, raw), SourceState::not_ready);
  for (const Tick tick : {10U, 11U, 19U}) {
    ASSERT_EQ(source.read(tick, raw), SourceState::ready);
    EXPECT_EQ(raw.tick, tick);
    EXPECT_EQ(raw.count, 2U);
    EXPECT_EQ(raw.values[0], 1.25);
    EXPECT_EQ(raw.values[1], -2e-3);
  }
  for (const Tick tick : {20U, 21U, 1000000000U}) {
    ASSERT_EQ(source.read(tick, raw), SourceState::ready);
    EXPECT_EQ(raw.values[0], 3);
    EXPECT_TRUE(std::isnan(raw.values[1]));
  }
  ASSERT_EQ(source.read(15, raw), SourceState::ready);  // going back is permitted
  EXPECT_EQ(raw.values[0], 1.25);
}

TEST(ReplaySource, ReplaysExactlyTheWrittenValues) {
  const task_test::ScratchFolder scratch;
  const bool ok = rc::check("the value at tick k is that of the last line with tick <= k", [&] {
    struct Line {
      Tick tick;
      double a, b;
    };
    std::vector<Line> lines;
    std::string text = "# mrroc readings a b\n";
    Tick tick = *rc::gen::inRange<Tick>(0, 5);
    const int count = *rc::gen::inRange(1, 30);
    for (int i = 0; i < count; ++i) {
      lines.push_back({tick, *rc::gen::arbitrary<double>(), *rc::gen::arbitrary<double>()});
      char line[128];
      std::snprintf(line, sizeof line, "%llu %.17g %.17g\n", static_cast<unsigned long long>(tick), lines.back().a,
                    lines.back().b);
      text += line;
      tick += *rc::gen::inRange<Tick>(1, 6);
    }
    ReplaySource source(scratch.write("r.txt", text), kTwo);
    for (Tick wanted = 0; wanted < tick + 3; ++wanted) {
      const Line* last = nullptr;
      for (const Line& line : lines) {
        if (line.tick <= wanted) last = &line;
      }
      RawReading raw;
      const SourceState state = source.read(wanted, raw);
      RC_ASSERT(state == (last == nullptr ? SourceState::not_ready : SourceState::ready));
      if (last != nullptr) {
        RC_ASSERT(raw.values[0] == last->a);
        RC_ASSERT(raw.values[1] == last->b);
      }
    }
  });
  EXPECT_TRUE(ok);
}

TEST(ReplaySource, AcceptsAdditionsOfEditors) {
  const task_test::ScratchFolder scratch;
  for (const char* const text :
       {"\xEF\xBB\xBF# mrroc readings a b\n5 1 2\n", "# mrroc readings a b\r\n5 1 2\r\n",
        "# mrroc readings a b \t\n\n+5 +1 2. \t", "# mrroc readings a b\n5\t1\t2\t# from the press\r\n\x1A",
        "\xEF\xBB\xBF# mrroc readings a b\r\n5 1e0 20.e-1\n"}) {
    ReplaySource source(scratch.write("r.txt", text), kTwo);
    RawReading raw;
    EXPECT_EQ(source.read(4, raw), SourceState::not_ready) << text;
    ASSERT_EQ(source.read(5, raw), SourceState::ready) << text;
    EXPECT_EQ(raw.values[0], 1) << text;
    EXPECT_EQ(raw.values[1], 2) << text;
  }
}

struct Malformed {
  const char* text;
  const char* message;
};

const Malformed kMalformed[] = {
    {"", "r.txt:1: header: '', expected '# mrroc readings a b'"},
    {"0 1 2\n", "r.txt:1: header: '0 1 2', expected '# mrroc readings a b'"},
    {"# mrroc reading a b\n0 1 2\n", "r.txt:1: header: '# mrroc reading a b', expected '# mrroc readings a b'"},
    {"\n# mrroc readings a b\n0 1 2\n", "r.txt:1: header: '', expected '# mrroc readings a b'"},
    {"# mrroc readings\n0\n",
     "r.txt:1: header: channels of another sensor: '# mrroc readings', expected '# mrroc readings a b'"},
    {"# mrroc readings a\n0 1\n",
     "r.txt:1: header: channels of another sensor: '# mrroc readings a', expected '# mrroc readings a b'"},
    {"# mrroc readings b a\n0 1 2\n",
     "r.txt:1: header: channels of another sensor: '# mrroc readings b a', expected '# mrroc readings a b'"},
    {"# mrroc readings a b c\n0 1 2 3\n",
     "r.txt:1: header: channels of another sensor: '# mrroc readings a b c', expected '# mrroc readings a b'"},
    {"# mrroc readings a b\n", "r.txt:1: values: no readings, expected at least one line below the header"},
    {"# mrroc readings a b\n# nothing\n\n",
     "r.txt:3: values: no readings, expected at least one line below the header"},
    {"# mrroc readings a b\n0 1 2\n# mrroc readings a b\n1 1 2\n",
     "r.txt:3: header: a second header, expected one, in the first line"},
    {"# mrroc readings a b\n-1 1 2\n", "r.txt:2: tick: '-1' is not a tick, expected a whole number of at least 0"},
    {"# mrroc readings a b\n1.5 1 2\n", "r.txt:2: tick: '1.5' is not a tick, expected a whole number of at least 0"},
    {"# mrroc readings a b\nx 1 2\n", "r.txt:2: tick: 'x' is not a number, expected a whole number of at least 0"},
    {"# mrroc readings a b\n18446744073709551615 1 2\n",
     "r.txt:2: tick: '18446744073709551615' is not a tick, expected a whole number of at least 0"},
    {"# mrroc readings a b\n99999999999999999999 1 2\n",
     "r.txt:2: tick: '99999999999999999999' is not a tick, expected a whole number of at least 0"},
    {"# mrroc readings a b\n5 1 2\n5 1 2\n", "r.txt:3: tick: 5 follows 5, expected a later tick"},
    {"# mrroc readings a b\n5 1 2\n\n4 1 2\n", "r.txt:4: tick: 4 follows 5, expected a later tick"},
    {"# mrroc readings a b\n5\n", "r.txt:2: values: 0, expected 2 after the tick"},
    {"# mrroc readings a b\n5 1\n", "r.txt:2: values: 1, expected 2 after the tick"},
    {"# mrroc readings a b\n5 1 2 3\n", "r.txt:2: values: 3, expected 2 after the tick"},
    {"# mrroc readings a b\n5 1 # 2\n", "r.txt:2: values: 1, expected 2 after the tick"},
    {"# mrroc readings a b\n5 1,2\n", "r.txt:2: values: 1, expected 2 after the tick"},
    {"# mrroc readings a b\n5 1,5 2\n", "r.txt:2: a: '1,5' has a decimal comma, expected a finite number or nan"},
    {"# mrroc readings a b\n0 1 2\n5 1 two\n", "r.txt:3: b: 'two' is not a number, expected a finite number or nan"},
    {"# mrroc readings a b\n5 1 0x10\n", "r.txt:2: b: '0x10' is not a number, expected a finite number or nan"},
    {"# mrroc readings a b\n5 1 inf\n", "r.txt:2: b: 'inf' is not finite, expected a finite number or nan"},
    {"# mrroc readings a b\n5 -inf 1\n", "r.txt:2: a: '-inf' is not finite, expected a finite number or nan"},
    {"# mrroc readings a b\n5 1e999 1\n", "r.txt:2: a: '1e999' is not a number, expected a finite number or nan"},
    {"# mrroc readings a b\n0,5 1 1\n",
     "r.txt:2: tick: '0,5' has a decimal comma, expected a whole number of at least 0"},
    {"# mrroc readings a b\n5 1\xC2\xA0 1\n",
     "r.txt:2: a: '1U+00A0' has U+00A0 at character 2, expected a finite number or nan"},
    {"# mrroc readings a b\r5 1 1\r",
     "r.txt:1: a carriage return (\\x0D) at column 21, expected lines that end with LF or CRLF"},
    {"\xFF\xFE#", "r.txt:1: the file is in UTF-16, expected UTF-8 (choose it when the file is saved)"},
    {"# mrroc readings a b\n5 \x01 1\n",
     "r.txt:2: a: '\\x01' has \\x01 at character 1, expected a finite number or nan"},
};

TEST(ReplaySource, RefusesEveryMalformedFileWithFileAndLine) {
  const task_test::ScratchFolder scratch;
  for (const Malformed& malformed : kMalformed) {
    const std::filesystem::path file = scratch.write("r.txt", malformed.text);
    EXPECT_EQ(config::message_of(scratch.path(), [&] { ReplaySource(file, kTwo); }), malformed.message)
        << malformed.text;
  }
}

TEST(ReplaySource, RefusesAnUnreadableFile) {
  const task_test::ScratchFolder scratch;
  EXPECT_THROW(ReplaySource(scratch.path() / "none.txt", kTwo), config::ConfigurationError);
  EXPECT_THROW(ReplaySource(scratch.path(), kTwo), config::ConfigurationError);
}

}  // namespace
}  // namespace mrroc::vsp::replay_source_test
