// Two belts: coordination of the programs of ECPs by an MP, and of its own robots at the same time. The operator
// selects the scenario.
#include <cstdio>

#include "mrroc/generators/together.hpp"
#include "mrroc/mp.hpp"
#include "mrroc/robots/conveyor.hpp"
#include "mrroc/stopped.hpp"
#include "system/programs/coordination.hpp"

using namespace mrroc;

namespace mrroc::test {
namespace {

class Coordination : public mp::Task {
  Conveyor left{*this, "left"};
  Conveyor right{*this, "right"};

  void run() override {
    const std::vector<std::string> scenarios{"behaviours", "messages",  "fibers", "shared",
                                             "failing",    "questions", "pause"};
    switch (ask_choice("Which?", scenarios)) {
      case 0:
        return behaviours();
      case 1:
        return messages();
      case 2:
        return fibers();
      case 3:
        return shared();
      case 4:
        return failing();
      case 5:
        return questions();
      default:
        return pause();
    }
  }

  void show(const std::string& belt) {
    const auto arrived = take<Arrived>(belt);
    if (!arrived) {
      std::printf("%s: nothing\n", belt.c_str());
      return;
    }
    std::printf("%s at %.3f m by %s\n", belt.c_str(), arrived->position, arrived->by.c_str());
  }

  void refused(const std::function<void()>& attempt) {
    try {
      attempt();
      std::printf("not refused\n");
    } catch (const Error& error) {
      std::printf("refused: %s\n", error.what());
    }
  }

  void behaviours() {
    start("left", Go{0.05, 0.9});
    start("right", Go{0.30, 0.9});
    refused([this] { start("left", Go{0.10, 0.9}); });
    const std::string first = wait_for_any({"right", "left"});
    std::printf("first: %s, right %s\n", first.c_str(), running("right") ? "runs" : "has ended");
    start(first, Go{0.0, 0.9});
    wait_for_all({"left", "right"});
    show("left");
    show("right");
    show("left");
    refused([this] { perform("left", Fly{}); });
    refused([this] { start("nobody", Go{}); });
    start("left", Run{0.02});
    Move({right}, {}, JointLine{right, Conveyor::at(0.2), 0.9});
    end_motion("left");
    wait_for_all({"left"});
    show("left");
  }

  void messages() {
    start("left", Run{0.01});
    Wait({right}, {}, ElapsedSteps{50});
    tell("left", Faster{0.03});
    Wait({right}, {}, When{"left has heard", [this] { return heard<Arrived>("left"); }});
    show("left");
    show("left");
    // once more while it still gains speed
    Wait({right}, {}, ElapsedSteps{5});
    tell("left", Faster{0.02});
    Wait({right}, {}, ElapsedSteps{5});
    start("right", Run{0.01});
    tell("right", Faster{0.02});
    wait_until([this] { return heard<Arrived>("left") && heard<Arrived>("right"); });
    end_motion("left");
    end_motion("right");
    wait_for_all();
    std::printf("all have ended\n");
  }

  /// Two simultaneous Moves of different lengths and macrosteps, and a third part without a robot.
  void fibers() {
    left.set_macrostep(10, 8);
    right.set_macrostep(7, 5);
    int done = 0;
    concurrently({[&] {
                    for (int way = 0; way < 3; ++way) Move({left}, {}, JointLine{left, Conveyor::at(0.02 * way), 0.9});
                    ++done;
                  },
                  [&] {
                    Move({right}, {}, JointLine{right, Conveyor::at(0.2), 0.9});
                    if (ask_yes_no("Back?")) Move({right}, {}, JointLine{right, Conveyor::at(0.0), 0.9});
                    ++done;
                  },
                  [&] {
                    wait_until([&] { return done == 2; });
                    std::printf("both are there\n");
                  }});
    right.set_macrostep(10, 8);
    Move({left, right}, {},
         Together{JointLine{left, Conveyor::at(0.1), 0.9}, JointLine{right, Conveyor::at(0.1), 0.9}});
    std::printf("left %.3f m, right %.3f m\n", left.state().desired_joints[0], right.state().desired_joints[0]);
  }

  void shared() {
    refused([this] {
      concurrently({[this] {
                      Move({left}, {}, JointLine{left, Conveyor::at(0.2), 0.9});
                    },
                    [this] {
                      Move({left, right}, {}, Hold{right, 0.1});
                    }});
    });
    refused([this] { concurrently({[this] { concurrently({[] {}}); }}); });
    Move({left}, {}, JointLine{left, Conveyor::at(0.0), 0.9});
    std::printf("left %.3f m\n", left.state().desired_joints[0]);
  }

  void failing() {
    bool stopped = false;
    refused([&] {
      concurrently({[&] {
                      try {
                        Move({left}, {}, ToolVelocity{left, {0.02, 0, 0}});
                      } catch (const Stopped&) {
                        stopped = true;
                        throw;
                      }
                    },
                    [this] {
                      Move({right}, {}, JointLine{right, Conveyor::at(0.1), 0.9});
                      throw NonFatalError{"no part on the right"};
                    }});
    });
    Move({left}, {}, Hold{left, 0.3});
    std::printf("left %s, %.3f m/s\n", stopped ? "was stopped" : "went on", left.state().desired_velocity[0]);
  }

  void questions() {
    const bool more = ask_yes_no("More?"), still_more = ask_yes_no("More?");
    std::printf("more %d, still more %d, length %.2f\n", more, still_more, ask_number("How long?", 0, 2));
    start("left", Ask{});
    wait_for_all();
    show("left");
    refused([this] { ask_number("How long?", 5, 6); });
    refused([this] { ask_choice("Which?", {}); });
    refused([this] { tell_operator(std::string(128, 'x')); });
    ask_yes_no("Is anybody there?");
  }

  /// Paused and resumed by events of the deployment.
  void pause() {
    start("left", Go{0.15, 0.9});
    concurrently({[this] {
                    Move({right}, {}, JointLine{right, Conveyor::at(0.15), 0.9});
                  },
                  [this] { wait_for_all({"left"}); }});
    show("left");
    std::printf("right at %.3f m\n", right.state().desired_joints[0]);
  }
};

}  // namespace
}  // namespace mrroc::test

MRROC_MP(mrroc::test::Coordination)
