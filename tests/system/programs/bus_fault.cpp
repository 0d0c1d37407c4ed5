// The arm moves to and fro. Whenever a drive stops it, it recovers, repeatedly until the cause is gone, and moves home.
#include <cstdio>

#include "mrroc/ecp.hpp"
#include "mrroc/generators/joint_line.hpp"
#include "mrroc/robots/irb6.hpp"
#include "require.hpp"

using namespace mrroc;
using mrroc::test::require;

namespace {

class BusFault : public ecp::Task {
  static constexpr int kLines = 6;   // 10 s
  static constexpr int kTries = 20;  // each failing one takes up to 2 s
  static constexpr Tick kBetweenTries = 50;
  Irb6 arm{*this};

  void go(double height) { Move({arm}, {}, JointLine{arm, Irb6::tool_down(0.75, 0, height)}); }

  bool goes_home() {
    try {
      arm.recover();
      go(0);
      return true;
    } catch (const HardwareError& error) {
      std::printf("not yet: %s\n", error.what());
      sleep_until(tick() + kBetweenTries);
      return false;
    }
  }

  void run() override {
    bool stopped = false;
    try {
      for (int i = 0; i < kLines; ++i) go(i % 2 == 0 ? 0.1 : 0);
    } catch (const HardwareError& error) {
      std::printf("stopped: %s\n", error.what());
      stopped = true;
    }
    require(stopped, "no fault has occurred");
    int tries = 1;
    while (!goes_home()) require(++tries <= kTries, "the robot does not recover although the cause is gone");
    std::printf("recovered\n");
  }
};

}  // namespace

MRROC_ECP(BusFault)
