// Meets the errors of a behaviour: those that the ECP catches, then one in a wait, one in its own Move, and an uncaught
// one.
#include <cmath>
#include <cstdio>

#include "mrroc/mp.hpp"
#include "mrroc/robots/conveyor.hpp"
#include "system/programs/failing.hpp"
#include "system/programs/nested.hpp"
#include "system/programs/require.hpp"

using namespace mrroc;

namespace mrroc::test {
namespace {

class Nested : public mp::Task {
  Conveyor left{*this, "left"};
  Conveyor right{*this, "right"};

  void run() override {
    for (const int where : {0, 1}) {
      perform("left", Fail{where});
      const auto caught = take<Caught>("left");
      require(caught.has_value(), "the ECP has caught nothing");
      std::printf("caught %s: step %d tick %d, moved %.6f m\n", caught->where.c_str(), static_cast<int>(caught->step),
                  static_cast<int>(caught->tick), caught->moved);
    }
    try {
      perform("left", Fail{2});
    } catch (const NonFatalError& error) {
      show("in a wait of the MP", error);
      require(error.black_box() == nullptr, "the steps of the ECP are not those of the MP");
    }
    rests("left", left);

    start("left", Fail{2});
    const double begin = right.state().desired_joints[0];
    try {
      Move({right}, {}, ToolVelocity{right, {0.03, 0, 0}});
    } catch (const NonFatalError& error) {
      show("in a Move of the MP", error);
      const StepRecord& last = error.black_box()->newest();
      require(last.instruction->robots.front() == "right" && last.ending == StepEnding::non_fatal_error,
              "the black box is not that of the Move");
      require(last.states.front().desired_joints[0] > begin + 0.001, "the belt did not run");
    }
    sleep_until(tick() + 200);
    rests("left", left);
    rests("right", right);

    // two simultaneous Moves, of which one fails
    right.set_macrostep(7, 5);
    concurrently({[this] {
                    Move({left}, {}, ToolVelocity{left, {0.03, 0, 0}});
                  },
                  [this] {
                    Wait({right}, {}, ElapsedSteps{20});
                    Move({right}, {}, Failing{right});
                  }});
  }

  void show(const char* where, const Error& error) {
    const ErrorOrigin& origin = error.origin();
    std::printf("caught %s: class %d code %d process %s step %d tick %d\n", where,
                static_cast<int>(error.error_class()), static_cast<int>(error.code()), origin.process.c_str(),
                static_cast<int>(origin.step), static_cast<int>(origin.tick));
  }

  /// The robot is at rest without commands, and stays at rest.
  void rests(const char* name, Robot& belt) {
    Wait({belt}, {}, ElapsedSteps{1});
    const double place = belt.state().desired_joints[0];
    Wait({belt}, {}, ElapsedSteps{50});
    std::printf("%s rests, moved %.6f m\n", name, std::abs(belt.state().desired_joints[0] - place));
  }
};

}  // namespace
}  // namespace mrroc::test

MRROC_MP(mrroc::test::Nested)
