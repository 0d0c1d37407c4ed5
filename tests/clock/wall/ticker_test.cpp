#include "clock/wall/ticker.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <sched.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "clock/child.hpp"
#include "clock/wall/monotonic.hpp"
#include "clock/wall/realtime.hpp"
#include "privileges.hpp"
#include "repetitions.hpp"

namespace mrroc::clock::ticker_test {
namespace {

constexpr std::int64_t kPeriod = 1'000'000;

void delay_until(std::int64_t ns) {
  while (monotonic_ns() < ns) {
  }
}

TEST(Ticker, ReturnsOrCountsEveryTickOnAFixedGrid) {
  const std::int64_t epoch = monotonic_ns() + 2 * kPeriod;
  Ticker ticker(epoch, kPeriod);
  Tick last = ticker.wait_next();
  std::uint64_t returned = 1;
  EXPECT_GE(monotonic_ns(), epoch + static_cast<std::int64_t>(last) * kPeriod);
  EXPECT_EQ(last, ticker.statistics().missed());  // the grid begins with tick 0
  for (int i = 0; i < 60; ++i) {
    const std::uint64_t missed = ticker.statistics().missed();
    // a tick that overruns four periods and a little: at least three are lost entirely
    const bool overrun = i % 20 == 10;
    if (overrun) delay_until(epoch + static_cast<std::int64_t>(last) * kPeriod + kPeriod * 201 / 50);
    const auto present = static_cast<Tick>((monotonic_ns() - epoch) / kPeriod);
    const Tick tick = ticker.wait_next();
    EXPECT_GE(tick, present);  // on a grid that had slipped by more than that little it would lag behind
    ++returned;
    EXPECT_GE(monotonic_ns(), epoch + static_cast<std::int64_t>(tick) * kPeriod);
    EXPECT_GT(tick, last);
    EXPECT_EQ(ticker.statistics().missed() - missed, tick - last - 1);
    EXPECT_GE(ticker.statistics().missed() - missed, overrun ? 3U : 0U);
    last = tick;
  }
  EXPECT_EQ(ticker.statistics().ticks(), returned);
  EXPECT_EQ(ticker.statistics().ticks() + ticker.statistics().missed(), last + 1);
  EXPECT_EQ(ticker.statistics().lateness().count(), returned);
  EXPECT_EQ(ticker.statistics().execution().count(), returned - 1);
  EXPECT_LT(ticker.statistics().lateness().max(),
            static_cast<std::uint64_t>(kPeriod));  // the present tick is never a period old
  EXPECT_GE(ticker.statistics().execution().max(), static_cast<std::uint64_t>(3 * kPeriod));
}

TEST(Ticker, BeginsWithTheNextTickAfterTheEpoch) {
  const std::int64_t epoch = monotonic_ns() - 100 * kPeriod;
  Ticker ticker(epoch, kPeriod);
  EXPECT_GE(ticker.wait_next(), 101U);
  EXPECT_LT(ticker.statistics().missed(), 100U);  // ticks before its construction do not count
}

TEST(Histogram, IsEmptyAtFirst) {
  const Histogram histogram;
  EXPECT_EQ(histogram.count(), 0U);
  EXPECT_EQ(histogram.max(), 0U);
  EXPECT_EQ(histogram.percentile(0.5), 0U);
}

RC_GTEST_PROP(Histogram, PercentileIsAtMostOneSixteenthTooLarge, ()) {
  const auto values = *rc::gen::nonEmpty(rc::gen::container<std::vector<std::int64_t>>(
      rc::gen::withSize([](int size) { return rc::gen::inRange<std::int64_t>(0, std::int64_t{1} << (size % 40)); })));
  const double p = *rc::gen::element(0.01, 0.5, 0.99, 1.0);
  Histogram histogram;
  for (const std::int64_t value : values) histogram.add(value);
  std::vector<std::int64_t> sorted = values;
  std::sort(sorted.begin(), sorted.end());
  const auto rank = static_cast<std::size_t>(std::ceil(p * static_cast<double>(sorted.size())));
  const auto exact = static_cast<std::uint64_t>(sorted[rank - 1]);
  RC_ASSERT(histogram.percentile(p) >= exact);
  RC_ASSERT(histogram.percentile(p) <= exact + exact / 16);
  RC_ASSERT(histogram.max() == static_cast<std::uint64_t>(sorted.back()));
}

TEST(Realtime, IsGrantedOrWarnsWhatIsMissing) {
  Child asking([] {
    const std::string warning = request_realtime(10);
    const bool fifo = ::sched_getscheduler(0) == SCHED_FIFO;
    if (fifo == (warning.find("SCHED_FIFO 10 refused") != std::string::npos)) ::_exit(1);
  });
  Child foreseeing([] {
    const std::string refused = refused_realtime(10);
    if (::sched_getscheduler(0) != SCHED_OTHER) ::_exit(1);
    const std::string warning = request_realtime(10);
    if ((refused.find("real-time priority") == std::string::npos) == warning.starts_with("SCHED_FIFO")) ::_exit(2);
    if ((refused.find("locked memory") == std::string::npos) ==
        (warning.find("locked memory refused") != std::string::npos))
      ::_exit(3);
  });
  EXPECT_TRUE(foreseeing.join());
  EXPECT_TRUE(asking.join());
  Child without_rights([] {
    const rlimit none{0, 0};
    if (::setrlimit(RLIMIT_RTPRIO, &none) != 0 || (::geteuid() == 0 && ::setuid(65534) != 0)) ::_exit(1);
    if (request_realtime(10).find("SCHED_FIFO 10 refused (Operation not permitted)") == std::string::npos) ::_exit(2);
  });
  EXPECT_TRUE(without_rights.join());
}

TEST(Realtime, MemoryIsNotLockedBelowALimitThatLaterMemoryWouldMeet) {
  for (const rlim_t wanted : {rlim_t{0}, rlim_t{64} << 10, rlim_t{64} << 20, rlim_t{256} << 20, rlim_t{1} << 30}) {
    Child child([wanted] {
      test::drop_capabilities();
      rlimit limit{};
      ::getrlimit(RLIMIT_MEMLOCK, &limit);
      limit.rlim_cur = limit.rlim_max = std::min(limit.rlim_max, wanted);
      if (::setrlimit(RLIMIT_MEMLOCK, &limit) != 0) ::_exit(1);
      const bool refused = request_realtime(10).find("locked memory refused") != std::string::npos;
      if (!refused && !test::kSanitized) ::_exit(2);  // a sanitizer takes the call for itself
      rlimit after{};
      ::getrlimit(RLIMIT_MEMLOCK, &after);
      if (after.rlim_cur != limit.rlim_cur) ::_exit(3);
      constexpr std::size_t kLarge = std::size_t{2} << 30;
      if (::mmap(nullptr, kLarge, PROT_READ, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0) == MAP_FAILED)
        ::_exit(4);
    });
    EXPECT_TRUE(child.join()) << wanted;
  }
}

TEST(Realtime, AShortSliceNeedsNoPrivilegeAndKeepsClassAndNiceness) {
  Child child([] {
    test::drop_capabilities();
    if (::setpriority(PRIO_PROCESS, 0, 3) != 0) ::_exit(1);
    take_short_slice();
    std::array<std::uint32_t, 12> attributes{};  // sched_getattr(2): size, policy, flags, nice, priority, runtime ...
    if (::syscall(SYS_sched_getattr, 0, attributes.data(), sizeof attributes, 0) != 0) ::_exit(2);
    if (attributes[1] != SCHED_OTHER || attributes[4] != 3) ::_exit(3);
    const std::uint32_t slice = attributes[6];
    if (slice != 100'000 && slice != 0) ::_exit(4);  // 0: of a kernel that does not know slices
  });
  EXPECT_TRUE(child.join());
}

TEST(Realtime, PinnedProcessesAndTheirChildrenHaveOneCpu) {
  Child pinned([] {
    const int cpu = pin_to_one_cpu();
    Child child([cpu] {
      cpu_set_t set;
      if (::sched_getaffinity(0, sizeof set, &set) != 0 || CPU_COUNT(&set) != 1 ||
          !CPU_ISSET(static_cast<unsigned>(cpu), &set))
        ::_exit(1);
    });
    if (!child.join()) ::_exit(1);
  });
  EXPECT_TRUE(pinned.join());
}

}  // namespace
}  // namespace mrroc::clock::ticker_test
