// Moves an arm whose drives take their time, through one fault of them.
#include <cstdio>

#include "mrroc/ecp.hpp"
#include "mrroc/generators/joint_line.hpp"
#include "mrroc/robots/irb6.hpp"

using namespace mrroc;

class SlowPower : public ecp::Task {
  Irb6 arm{*this};

  void run() override {
    for (int laps = 0, faults = 0; laps < 2;) {
      try {
        const JointVector home = arm.parameters().home;
        Move({arm}, {}, JointLine{arm, home + JointVector::Constant(6, 0.02)});
        Move({arm}, {}, JointLine{arm, home});
        ++laps;
      } catch (const HardwareError& error) {
        if (++faults > 1) throw;
        std::printf("recovering: %s\n", error.what());
        arm.recover();
        std::puts("recovered");
      }
    }
    std::puts("moved");
  }
};

MRROC_ECP(SlowPower)
