// The arm moves to and fro. When its EDP stops or refuses a motion, the arm recovers, synchronises where positions are
// lost, and repeats the line until the cause is gone.
#include <cstdio>

#include "mrroc/ecp.hpp"
#include "mrroc/generators/joint_line.hpp"
#include "mrroc/robots/irb6.hpp"

using namespace mrroc;

namespace {

class Recovering : public ecp::Task {
  static constexpr int kLines = 6;  // 10 s
  static constexpr int kTries = 20;
  Irb6 arm{*this};

  void go(double height) { Move({arm}, {}, JointLine{arm, Irb6::tool_down(0.75, 0, height)}); }

  void pause() { sleep_until(tick() + 125); }  // 0.25 s

  /// False: the cause persists.
  bool stands_again() {
    try {
      arm.recover();
      if (arm.state().synchronised) return true;
      arm.synchronise();
      Move({arm}, {}, JointLine{arm, arm.parameters().home});  // not every line is free from the switches
      return true;
    } catch (const HardwareError& error) {
      std::printf("not yet: %s\n", error.what());
      return false;
    }
  }

  void run() override {
    int tries = 0;
    for (int line = 0; line < kLines;) {
      try {
        go(line % 2 == 0 ? 0.1 : 0);
        ++line;
      } catch (const HardwareError& error) {
        std::printf("stopped: %s\n", error.what());
        do {
          if (++tries > kTries) throw;
          pause();
        } while (!stands_again());
      } catch (const NonFatalError& error) {  // nothing has moved, or the arm holds
        std::printf("refused: %s\n", error.what());
        if (++tries > kTries) throw;
        pause();
      }
    }
    std::printf("done\n");
  }
};

}  // namespace

MRROC_ECP(Recovering)
