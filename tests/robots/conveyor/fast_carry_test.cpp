// The fast conveyor of the demo in its scene, with its EDP core, at the limits of its speed and acceleration.
#include <gtest/gtest.h>

#include "robots/conveyor/conveyor_carries.hpp"

namespace mrroc {
namespace {

constexpr double kSpeed = 0.15;  // m/s

class FastConveyorCarries : public ConveyorCarries {
 protected:
  /// Moves for `seconds` at `speed`, reached from the previous speed as fast as the limits allow; calls `check` after
  /// every tick.
  template <class Check>
  void ride(double speed, int seconds, Check check) {
    for (int second = 0; second < seconds; ++second) {
      edp_.keep(speed, 500);
      for (int i = 0; i < 500; ++i) {
        run(1);
        check();
      }
    }
  }
};

TEST_F(FastConveyorCarries, PartsMoveAtFullSpeedWithoutSlipping) {
  const Eigen::Vector3d at_rest = parts();
  ride(kSpeed, 1, [] {});
  const Eigen::Vector3d before = parts();
  const double start = travel();
  double slowest = kSpeed, fastest = kSpeed;
  ride(kSpeed, 5, [&] {
    slowest = std::min(slowest, encoder().values[1]);
    fastest = std::max(fastest, encoder().values[1]);
  });
  std::printf("speed %.5f to %.5f m/s, slip %.3f mm from rest on, %.4f mm at the steady speed\n", slowest, fastest,
              1000 * slip(at_rest, travel()), 1000 * slip(before, travel() - start));
  EXPECT_GT(slowest, 0.99 * kSpeed);
  EXPECT_LT(fastest, 1.01 * kSpeed);
  EXPECT_NEAR(travel() - start, 5 * kSpeed, 1e-4);
  EXPECT_LT(slip(before, travel() - start), 1e-4);
  EXPECT_LT(slip(at_rest, travel()), 1e-3);
  ride(0, 1, [] {});
  EXPECT_LT(slip(at_rest, travel()), 1e-3) << "braked";
}

TEST_F(FastConveyorCarries, BeltFollowsItsPathWithinTheServosErrorAndCurrent) {
  double worst = 0, peak = 0;
  const auto check = [&] {
    worst = std::max(worst, std::abs(edp_.snapshot().desired.position[0] - travel()));
    peak = std::max(peak, std::abs(edp_.snapshot().current[0]));
  };
  ride(kSpeed, 3, check);
  std::printf("from rest: worst error %.2f mm, peak %.1f A\n", 1000 * worst, peak);
  ride(-kSpeed, 3, check);
  ride(0, 1, check);
  std::printf("and reversed: worst error %.2f mm, peak %.1f A\n", 1000 * worst, peak);
  EXPECT_LT(750 * worst, 0.7 * belt().following_error_max) << "rad of the motor";
  EXPECT_LT(peak, belt().current_max);
  EXPECT_EQ(edp_.snapshot().fault.code, ErrorCode::none);
}

}  // namespace
}  // namespace mrroc
