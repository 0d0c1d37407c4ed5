// The servo takes every edge of ServoState's table and no other.
#include "edp/servo/servo_state.hpp"

#include <gtest/gtest.h>

#include <random>

#include "edp/edges.hpp"
#include "edp/rig.hpp"

namespace mrroc::edp::servo_state_test {
namespace {

using S = ServoState;

/// The table in servo_state.hpp.
const EdgeTable<S> kEdges{{S::off, S::powering},
                          {S::off, S::on},
                          {S::off, S::cleared},
                          {S::powering, S::cleared},
                          {S::cleared, S::on},
                          {S::cleared, S::powering_cleared},
                          {S::powering, S::on},
                          {S::powering_cleared, S::on},
                          {S::cleared, S::off},
                          {S::powering, S::off},
                          {S::powering_cleared, S::off},
                          {S::on, S::stopping},
                          {S::on, S::off},
                          {S::stopping, S::off}};

/// Drives that take `delay` ticks to switch on and to reset.
class SlowDrives : public FaultyHardware {
 public:
  using FaultyHardware::FaultyHardware;
  void enable(bool on) noexcept override {
    FaultyHardware::enable(on);
    wait_ = on ? delay : 0;
  }
  void reset_fault() noexcept override {
    ++resets;
    wait_ = delay;
  }
  bool busy() const noexcept override { return wait_ > 0; }
  void read(Tick tick, HardwareInput& input) noexcept override {
    FaultyHardware::read(tick, input);
    if (wait_ > 0) --wait_;
  }
  int delay = 0, resets = 0;

 private:
  int wait_ = 0;
};

class Walk {
 public:
  explicit Walk(std::uint32_t seed) : random_(seed) {}

  void step() {
    const S before = servo_.snapshot().state;
    if (draw(8) == 0) order();
    if (draw(20) == 0) hardware_.delay = draw(3) == 0 ? 0 : draw(12);
    if (draw(30) == 0) {
      const ErrorCode kinds[]{ErrorCode::drive_fault, ErrorCode::bus_error};  // no power at once, after a stop
      hardware_.fault = kinds[draw(2)];
    } else if (draw(4) == 0) {
      hardware_.fault = ErrorCode::none;
    }
    if (servo_.snapshot().enabled() && draw(5) == 0)
      effector_.accept(joint_command(one(0.01 * draw(100)), 1500, 1500), ++number_, answer_);
    const int resets = hardware_.resets;
    servo_.tick(++now_);
    Reply reply;
    while (effector_.poll(reply)) {
    }
    const S after = servo_.snapshot().state;
    if (after != before) ++edges[{before, after}];
    if (resets != hardware_.resets) {
      EXPECT_FALSE(is_cleared(before)) << "faults are reset once";
    }
    EXPECT_EQ(has_power(after) || is_powering(after), hardware_.powered);
    if (after != before && after == S::on) {
      EXPECT_EQ(hardware_.fault, ErrorCode::none);
    }
  }

  void leave() {
    servo_.leave();
    for (int i = 0; i < 3000; ++i) step();
    EXPECT_EQ(servo_.snapshot().state, S::off);
    EXPECT_FALSE(servo_.drives_on());
  }

  Edges<S> edges;

 private:
  int draw(int below) { return std::uniform_int_distribution<int>(0, below - 1)(random_); }
  void order() {
    const DriveOrder orders[]{DriveOrder::enable, DriveOrder::disable, DriveOrder::recover};
    channel_.order.store(orders[draw(3)]);
  }

  std::mt19937 random_;
  Slide model_;
  SlowDrives hardware_{model_, kPeriod, true};
  ServoChannel channel_;
  ModelSet models_{model_};
  Servo servo_{models_, hardware_, kPeriod, channel_};
  Effector effector_{models_, kPeriod, channel_};
  Tick now_ = 0;
  std::uint64_t number_ = 0;
  Reply answer_;
};

TEST(ServoState, TakesEveryEdgeOfItsTableAndNoOther) {
  Edges<S> seen;
  for (std::uint32_t seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Walk walk(seed);
    for (int i = 0; i < 5000; ++i) walk.step();
    walk.leave();
    for (const auto& [edge, times] : walk.edges) seen[edge] += times;
  }
  expect_all_of(seen, kEdges);
}

}  // namespace
}  // namespace mrroc::edp::servo_state_test
