// A bus that loses, changes or delays random frames of every node: the robot continues or stops, in either case inside
// its limits, and `recover` works when the bus is in order again.
#include <gtest/gtest.h>

#include "bus_fault_rig.hpp"

namespace mrroc::edp {
namespace {

constexpr int kTicks = 150;
constexpr CanHardware::Timing kLossy{0.05};  // each tick that loses a frame waits as long

/// One kind of disturbance, in per cent of all frames.
struct Disturbance {
  std::string name;
  unsigned lost = 0, changed = 0;
  std::string netem;   ///< the same on the kernel's sockets
  bool stops = false;  ///< no robot can continue with it
  bool slows = false;  ///< answers come, but late
};

void begin(Rig& rig, const Disturbance& disturbance) {
  if (!rig.bus.is_hub()) return disturb(rig, disturbance.netem);
  rig.spoil.use([&rig, disturbance](can::Frame& frame) {
    if (rig.random() % 100 < disturbance.lost) return false;
    if (rig.random() % 100 < disturbance.changed && frame.size != 0)
      frame.data[rig.random() % frame.size] ^= static_cast<std::uint8_t>(1u << rig.random() % 8);
    return true;
  });
}

void end(Rig& rig) {
  rig.spoil.use({});
  if (!rig.bus.is_hub()) leave_in_peace(rig);
}

/// A test without an effect on frames shows nothing: an interface that does not echo bypasses netem.
void expect_disturbed(const Rig& rig, const Disturbance& disturbance) {
  const WeakBus& bus = *rig.weak_bus;
  if (disturbance.slows)
    EXPECT_GT(bus.slow, bus.cycles / 2);
  else
    EXPECT_TRUE(bus.unanswered > 0 || rig.fault().code != ErrorCode::none) << bus.cycles;
}

class DisturbedBus : public testing::TestWithParam<Disturbance> {};

TEST_P(DisturbedBus, KeepsTheRobotSafe) {
  for (unsigned seed = 1; seed <= seeds(); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Rig rig(seed, true, 0, GetParam().slows ? kTestTiming : kLossy);
    rig.weak_bus->cycles = rig.weak_bus->unanswered = rig.weak_bus->slow = 0;
    begin(rig, GetParam());
    for (int i = 0; i < kTicks && rig.servo->drives_on(); ++i) rig.tick();
    end(rig);
    if (rig.fault().code != ErrorCode::none) rig.stop();
    expect_disturbed(rig, GetParam());
    if (GetParam().stops) {
      EXPECT_NE(rig.fault().code, ErrorCode::none);
    }
    EXPECT_LE(rig.worst_speed, 1 + 1e-6);
    // a drive whose set-point is lost stands for a tick, and moves by two increments in the next
    EXPECT_LE(rig.worst_mean_speed, 1.5) << rig.text();
    if (rig.bus.is_hub() && GetParam().lost == 0) {
      EXPECT_LE(rig.worst_real_speed, 1.5) << rig.text();
    }
    EXPECT_LT(rig.moved, 0.01) << rig.text();
    rig.settle();
    if (rig.fault().code == ErrorCode::none) continue;
    EXPECT_TRUE(rig.recover()) << rig.text() << " " << rig.last.state.error.detail.view();
    EXPECT_TRUE(rig.moves_again()) << rig.text() << " " << rig.last.state.error.detail.view();
  }
}

std::vector<Disturbance> disturbances() {
  std::vector<Disturbance> all{{"LosesOneInFifty", 2, 0, "loss 2%"},
                               {"LosesOneInThree", 33, 0, "loss 33%", true},
                               {"ChangesOneInFifty", 0, 2, "corrupt 2%"}};
  // a hub has no delay
  if (std::getenv("MRROC_TEST_BUS") != nullptr)
    all.push_back({"DelaysAndOvertakes", 0, 0, "delay 2ms 2ms", false, true});
  return all;
}

INSTANTIATE_TEST_SUITE_P(Can, DisturbedBus, testing::ValuesIn(disturbances()),
                         [](const auto& each) { return each.param.name; });

}  // namespace
}  // namespace mrroc::edp
