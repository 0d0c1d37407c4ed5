// A belt whose behaviour meets an error in the middle of a motion, and catches it or not.
#include <cmath>

#include "mrroc/ecp.hpp"
#include "mrroc/robots/conveyor.hpp"
#include "system/programs/failing.hpp"
#include "system/programs/nested.hpp"

using namespace mrroc;

namespace mrroc::test {
namespace {

class Belt : public ecp::Task {
  Conveyor belt{*this};

 public:
  Belt() {
    on<Fail>([this](const Fail& fail) {
      if (fail.where == 0) return at_the_move();
      if (fail.where == 1) return around_several_moves();
      several_moves();
    });
  }

 private:
  void at_the_move() {
    try {
      Move({belt}, {}, Failing{belt});
    } catch (const NonFatalError& error) {
      tell_caught("at the Move", error);
    }
    Move({belt}, {}, JointLine{belt, Conveyor::at(0.0), 0.9});
  }

  void around_several_moves() {
    try {
      several_moves();
    } catch (const NonFatalError& error) {
      tell_caught("in the behaviour", error);
    }
    Move({belt}, {}, JointLine{belt, Conveyor::at(0.0), 0.9});
  }

  void several_moves() {
    Move({belt}, {}, JointLine{belt, Conveyor::at(0.02), 0.9});
    Move({belt}, {}, Failing{belt});
    Move({belt}, {}, JointLine{belt, Conveyor::at(0.0), 0.9});
  }

  /// Commands nothing for a while: the belt must have come to rest on its own, and stay there.
  void tell_caught(const char* where, const Error& error) {
    if (error.black_box()->newest().ending != StepEnding::non_fatal_error) throw NonFatalError("no black box");
    sleep_until(tick() + 200);
    Wait({belt}, {}, ElapsedSteps{1});
    const double place = belt.state().desired_joints[0];
    sleep_until(tick() + 200);
    Wait({belt}, {}, ElapsedSteps{1});
    tell(Caught{{where}, error.origin().step, error.origin().tick, std::abs(belt.state().desired_joints[0] - place)});
  }
};

}  // namespace
}  // namespace mrroc::test

MRROC_ECP(mrroc::test::Belt)
