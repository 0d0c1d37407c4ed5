#include "cli/output/trace.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>

#include "cli/output/trace_parts.hpp"
#include "mrroc/testing/scratch_folder.hpp"
#include "text_of.hpp"

namespace mrroc::cli::trace_test {
namespace {

class Trace : public testing::Test {
 protected:
  std::filesystem::path write(const std::string& name, const std::string& text) const {
    return folder_.write(name, text);
  }

  static void merge(const std::vector<std::filesystem::path>& parts, const std::filesystem::path& merged,
                    config::ClockMode clock) {
    std::ofstream file(merged, std::ios::binary);
    merge_traces(parts, clock, [&file](std::string_view text) { file << text; });
  }

  task_test::ScratchFolder folder_;
};

TEST_F(Trace, IgnoresTheRemainsOfAKilledRun) {
  const std::string text = "tick=1 process=arm step=0\n";
  const auto stale = write("t.arm.part", text);
  const PlannedProcess arm{.name = "arm", .program = {}, .has_task = true};
  const auto wait = [](int) { return true; };
  TraceOutput output(folder_ / "t", 0, wait);
  TraceParts parts(output, {arm});
  const std::string own = "tick=2 process=arm step=0\n";
  ASSERT_EQ(::write(parts.fd_of("arm"), own.data(), own.size()), static_cast<ssize_t>(own.size()));
  parts.join(output, config::ClockMode::lockstep, [](double) { return true; });
  EXPECT_EQ(test::text_of(folder_ / "t"), "# mrroc trace 2 clock=lockstep\n" + own);
  EXPECT_EQ(test::text_of(stale), text) << "the file belongs to another run";
  EXPECT_FALSE(std::filesystem::exists(folder_ / "t.arm.2.part"));
}

TEST_F(Trace, PartsStayWhenTheTraceIsLost) {
  const PlannedProcess arm{.name = "arm", .program = {}, .has_task = true};
  const auto wait = [](int) { return true; };
  TraceOutput output(folder_ / "t", 0, wait);
  TraceParts parts(output, {arm});
  std::filesystem::remove(folder_ / "t");
  write("t", "another program's");
  EXPECT_THROW(parts.join(output, config::ClockMode::lockstep, [](double) { return true; }), std::runtime_error);
  EXPECT_TRUE(std::filesystem::exists(folder_ / "t.arm.part"));
  EXPECT_EQ(test::text_of(folder_ / "t"), "another program's");
}

TEST_F(Trace, PartsAreMergedByTickThenProcessThenOrder) {
  const auto b = write("t.b.part", "tick=1 process=b step=0\ntick=9 process=b step=1\ntick=9 process=b step=2\n");
  const auto a = write("t.a.part", "tick=1 process=a step=0\ntick=10 process=a step=1\n");
  const auto merged = folder_ / "t";
  merge({b, a}, merged, config::ClockMode::lockstep);
  EXPECT_EQ(
      test::text_of(merged),
      "# mrroc trace 2 clock=lockstep\ntick=1 process=a step=0\ntick=1 process=b step=0\ntick=9 process=b step=1\n"
      "tick=9 process=b step=2\ntick=10 process=a step=1\n");
}

TEST_F(Trace, ALineWithoutATickStaysBelowTheOneBefore) {
  const auto a = write("t.a.part", "tick=5 process=a step=0\n# process=a lines=1 dropped=3 cut=0\n");
  const auto b = write("t.b.part", "tick=1 process=b step=0\ntick=7 process=b step=1\n");
  merge({a, b}, folder_ / "t", config::ClockMode::lockstep);
  EXPECT_EQ(test::text_of(folder_ / "t"),
            "# mrroc trace 2 clock=lockstep\ntick=1 process=b step=0\ntick=5 process=a step=0\n# process=a lines=1 "
            "dropped=3 cut=0\n"
            "tick=7 process=b step=1\n");
}

TEST_F(Trace, ALineWithAnOlderTickStaysBelowTheOneBefore) {
  const auto a = write("t.a.part", "tick=5 process=a step=0\ntick=3 process=a step=1\n");
  const auto b = write("t.b.part", "tick=4 process=b step=0\n");
  merge({a, b}, folder_ / "t", config::ClockMode::real);
  EXPECT_EQ(test::text_of(folder_ / "t"),
            "# mrroc trace 2 clock=real\ntick=4 process=b step=0\ntick=5 process=a step=0\ntick=3 process=a step=1\n");
}

TEST_F(Trace, MergedPartsEqualAllLinesSorted) {
  EXPECT_TRUE(rc::check([this] {
    struct Sorted {
      int tick;
      std::string text;
    };
    std::vector<Sorted> all;
    std::vector<std::filesystem::path> parts;
    const int count = *rc::gen::inRange(0, 5);
    for (int part = 0; part < count; ++part) {
      std::string text;
      int newest = 0;
      for (const int tick : *rc::gen::container<std::vector<int>>(rc::gen::inRange(-2, 12))) {  // below 0: no tick
        newest = std::max(newest, tick);
        all.push_back({newest, tick < 0 ? "# a remark\n"
                                        : "tick=" + std::to_string(tick) + " process=" + std::to_string(part) +
                                              " step=" + std::to_string(all.size()) + "\n"});
        text += all.back().text;
      }
      parts.push_back(
          write("t." + std::to_string(part) + ".part", text + (*rc::gen::arbitrary<bool>() ? "tick=3" : "")));
    }
    std::stable_sort(all.begin(), all.end(), [](const Sorted& a, const Sorted& b) { return a.tick < b.tick; });
    std::string expected = "# mrroc trace 2 clock=paced\n";
    for (const Sorted& line : all) expected += line.text;
    merge(parts, folder_ / "t", config::ClockMode::paced);
    RC_ASSERT(test::text_of(folder_ / "t") == expected);
  }));
}

TEST_F(Trace, IgnoresAnUnfinishedLineOfAKilledProcess) {
  const auto a = write("t.a.part", "tick=5 process=a step=0\ntick=15 proc");
  merge({a}, folder_ / "t", config::ClockMode::lockstep);
  EXPECT_EQ(test::text_of(folder_ / "t"), "# mrroc trace 2 clock=lockstep\ntick=5 process=a step=0\n");
}

TEST_F(Trace, EqualTracesHaveEqualHashesAndOthersDiffer) {
  const auto one = write("one", "# mrroc trace 2 clock=lockstep\ntick=1\n");
  const auto same = write("same", "# mrroc trace 2 clock=lockstep\ntick=1\n");
  const auto other = write("other", "# mrroc trace 2 clock=lockstep\ntick=2\n");
  EXPECT_EQ(hash_trace(one), hash_trace(same));
  EXPECT_NE(hash_trace(one), hash_trace(other));
  const auto edited = write("edited", "\xEF\xBB\xBF# mrroc trace 2 clock=lockstep\r\ntick=1\r\n");
  EXPECT_EQ(hash_trace(one), hash_trace(edited)) << "a file transfer may change the line ends";
  EXPECT_EQ(hash_trace(one).size(), 16U);
  const auto ab = write("ab", "# mrroc trace 2 clock=lockstep\ntick=1\ntick=2\n"),
             ba = write("ba", "# mrroc trace 2 clock=lockstep\ntick=2\ntick=1\n");
  EXPECT_NE(hash_trace(ab), hash_trace(ba)) << "the order counts";
  EXPECT_NE(hash_trace(ab), hash_trace(one)) << "so does the last line";
}

TEST_F(Trace, RefusesAFileThatIsNotATraceWithItsLine) {
  const auto wrong = write("wrong", "hello\n");
  try {
    hash_trace(wrong);
    FAIL() << "hashed";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string{error.what()}.find("wrong:1: is not a trace"), std::string::npos);
  }
}

}  // namespace
}  // namespace mrroc::cli::trace_test
