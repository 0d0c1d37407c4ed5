// Starts the programs of two belts, one of which fails and one of which never ends, and moves a third meanwhile.
#include <cmath>
#include <cstdio>

#include "mrroc/mp.hpp"
#include "mrroc/robots/conveyor.hpp"

using namespace mrroc;

namespace {

class SuperiorTask : public mp::Task {
  Conveyor own{*this, "own"};
  Conveyor steady{*this, "steady"};

  void run() override {
    start("steady");
    start("failing");
    try {
      Move({own}, {}, JointLine{own, Conveyor::at(0.5)});
    } catch (const Error& error) {
      std::printf("reported: %s\n", error.what());
    }
    Move({own}, {}, JointLine{own, Conveyor::at(0.05)});
    std::printf("moved on to %.3f m\n", own.state().desired_joints[0]);
    try {
      Move({steady}, {}, Hold{steady, 0.1});
    } catch (const NonFatalError& error) {
      std::printf("refused: %s\n", error.what());
    }
    stop("steady");
    Move({steady}, {}, Hold{steady, 0.1});
    std::printf("steady stopped at %.2f m/s\n", std::abs(steady.state().joint_velocity[0]));
    stop("steady");
    wait_for_all();
    stop("nobody");
  }
};

}  // namespace

MRROC_MP(SuperiorTask)
