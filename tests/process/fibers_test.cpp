#include "process/fibers.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <sys/resource.h>
#include <unistd.h>

#include <fstream>

#include "mrroc/errors.hpp"
#include "mrroc/stopped.hpp"

namespace mrroc::process::fibers_test {
namespace {

/// Time advances only when a fiber waits for it; mail never comes.
class JumpingClock final : public clock::Clock {
 public:
  double period() const noexcept override { return 0.001; }
  Tick tick() const noexcept override { return tick_; }
  bool simulated() const noexcept override { return true; }
  double wall_seconds() const noexcept override { return 0; }
  bool start() override { return true; }
  clock::Wake wait(Tick wake_tick) override {
    if (wake_tick == kNever) throw std::logic_error("a wait without end");
    ++waits;
    if (interrupted) return clock::Wake::interrupted;
    tick_ = std::max(tick_, wake_tick);
    return clock::Wake::tick;
  }
  void interrupt() noexcept override { interrupted = true; }
  void notify() noexcept override {}
  clock::EmergencyStop& emergency_stop() noexcept override { return emergency_stop_; }
  clock::GroupStops& group_stops() noexcept override { return group_stops_; }
  int register_sender(std::string_view) override { return 0; }
  int register_receiver(std::string_view) override { return 0; }
  std::uint64_t delta() const noexcept override { return 0; }
  bool visible(std::uint64_t) const noexcept override { return true; }
  void sent(int) noexcept override {}
  void arrived(int) noexcept override {}

  int waits = 0;
  bool interrupted = false;

 private:
  Tick tick_ = 0;
  clock::EmergencyStop emergency_stop_;
  clock::GroupStops group_stops_;
};

class Fibers : public testing::Test {
 protected:
  void sleep_until(Tick tick) {
    while (clock.tick() < tick)
      if (clock.wait(tick) == clock::Wake::interrupted) throw Stopped{};
    if (clock.cancelled()) throw Stopped{};
  }
  void wait_until(const std::function<bool()>& holds) {
    clock.note_progress();
    while (!holds()) {
      if (clock.wait(kNever) == clock::Wake::interrupted || clock.cancelled()) throw Stopped{};
    }
    clock.note_progress();
  }

  JumpingClock* inner = new JumpingClock;
  FiberScheduler clock{std::unique_ptr<clock::Clock>(inner)};
};

TEST_F(Fibers, TakeTurnsInTheirOrderAtEachTick) {
  std::vector<std::string> log;
  const auto body = [&](const std::string& name, Tick period) {
    return [&log, this, name, period] {
      for (Tick tick = period; tick <= 12; tick += period) {
        sleep_until(tick);
        log.push_back(name + std::to_string(clock.tick()));
      }
    };
  };
  clock.run({body("a", 6), body("b", 4), body("c", 3)});
  EXPECT_EQ(log, (std::vector<std::string>{"c3", "b4", "a6", "c6", "b8", "c9", "a12", "b12", "c12"}));
  EXPECT_EQ(inner->waits, 6);
}

TEST_F(Fibers, ChangesOfOneAreVisibleToTheOthersAtOnce) {
  EXPECT_TRUE(rc::check([this] {
    // fiber k waits for number p(k), a permutation: only the others can wake it
    const auto count = *rc::gen::inRange(1, 6);
    std::vector<int> order;
    for (int i = 0; i < count; ++i) order.push_back(i);
    for (int i = count - 1; i > 0; --i)
      std::swap(order[static_cast<std::size_t>(i)], order[static_cast<std::size_t>(*rc::gen::inRange(0, i + 1))]);
    int done = 0;
    std::vector<std::function<void()>> bodies;
    for (const int turn : order)
      bodies.emplace_back([this, turn, &done] {
        wait_until([&] { return done == turn; });
        ++done;
      });
    clock.run(bodies);
    RC_ASSERT(done == count);
  }));
}

TEST_F(Fibers, FirstErrorStopsTheOthersAndIsThrown) {
  bool stopped = false;
  const auto run = [&] {
    clock.run({[&] {
                 try {
                   sleep_until(100);
                 } catch (const Stopped&) {
                   stopped = true;
                   throw;
                 }
               },
               [&] {
                 sleep_until(5);
                 throw NonFatalError{"no part"};
               },
               [&] { wait_until([] { return false; }); }});
  };
  EXPECT_THROW(run(), NonFatalError);
  EXPECT_TRUE(stopped);
  EXPECT_FALSE(clock.cancelled());
  int ran = 0;
  clock.run({[&] { ++ran; }, [&] { ++ran; }});
  EXPECT_EQ(ran, 2);
}

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)  // they need address space of their own
TEST_F(Fibers, ThreadThatCannotBeMadeIsAnError) {
  const auto run_without_memory = [this] {
    int ran = 0;
    const std::vector<std::function<void()>> bodies(300, [&ran] { ++ran; });
    std::size_t pages = 0;
    std::ifstream("/proc/self/statm") >> pages;
    const rlim_t size = pages * static_cast<rlim_t>(sysconf(_SC_PAGESIZE)) + (rlim_t{512} << 20);
    const rlimit limit{size, size};
    setrlimit(RLIMIT_AS, &limit);
    try {
      clock.run(bodies);
    } catch (const SystemError& error) {
      _exit(error.code() == ErrorCode::resources && ran == 0 ? 0 : 1);
    }
    _exit(2);
  };
  EXPECT_EXIT(run_without_memory(), testing::ExitedWithCode(0), "");
}
#endif

TEST_F(Fibers, InterruptedClockInterruptsEachOfThem) {
  int stopped = 0;
  const auto body = [&] {
    try {
      sleep_until(10);
    } catch (const Stopped&) {
      ++stopped;
      throw;
    }
  };
  inner->interrupt();
  EXPECT_THROW(clock.run({body, body, body}), Stopped);
  EXPECT_EQ(stopped, 3);
}

TEST_F(Fibers, CannotBeNested) {
  EXPECT_THROW(clock.run({[&] { clock.run({[] {}}); }}), NonFatalError);
  clock.run({});
}

}  // namespace
}  // namespace mrroc::process::fibers_test
