#include <array>

#include "testing/driver/checks.hpp"
#include "testing/driver/counts.hpp"

namespace mrroc::driver_test {

namespace {

/// What 200 servo ticks in motion do, the driver's calls among them; the servo itself does nothing of the kind.
void is_real_time(Bench& bench) {
  bench.open();
  bench.power();
  bench.start_move(1);
  bench.servo_ticks(20);
  Counts sum;
  for (int i = 0; i < 200; ++i) {
    // the device and the pace are the test's, not the driver's
    const Counts done = bench.count_servo_tick();
    sum.allocations += done.allocations;
    sum.locks += done.locks;
    sum.sleeps += done.sleeps;
  }
  if (counts_allocations()) {
    expect(sum.allocations == 0, std::to_string(sum.allocations) + " allocations in 200 ticks");
    expect(sum.locks == 0, std::to_string(sum.locks) + " locks in 200 ticks");
  }
  // a bus master waits for each answer of its slaves
  const auto most = 200 * (static_cast<std::uint64_t>(bench.axes()) + 1);
  expect(sum.sleeps <= most, std::to_string(sum.sleeps) + " sleeps in 200 ticks, at most " + std::to_string(most));
}

constexpr std::array kRealTimeChecks{
    Check{"real_time", "a tick allocates nothing, takes no lock, sleeps for answers only", is_real_time}};

}  // namespace

std::span<const Check> real_time_checks() { return kRealTimeChecks; }

}  // namespace mrroc::driver_test
