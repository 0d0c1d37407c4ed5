// Two arms in Moves of the MP; the ECP of the left one takes part. The operator selects the scenario.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "mrroc/generators/cartesian_line.hpp"
#include "mrroc/generators/together.hpp"
#include "mrroc/mp.hpp"
#include "mrroc/robots/irb6.hpp"
#include "system/programs/coordinated.hpp"

using namespace mrroc;

namespace mrroc::test {
namespace {

class CoordinatedMoves : public mp::Task {
  Irb6 left{*this, "left"};
  Irb6 right{*this, "right"};

  void run() override {
    const std::vector<std::string> scenarios{"mirror", "corrected", "first",  "error",
                                             "stay",   "busy",      "comply", "weave"};
    switch (ask_choice("Which?", scenarios)) {
      case 0:
        return mirror();
      case 1:
        return corrected();
      case 2:
        return first();
      case 3:
        return error();
      case 4:
        return stay();
      case 5:
        return busy();
      case 6:
        return comply();
      default:
        return weave();
    }
  }

  static JointVector moved(const Robot& robot, double by) {
    JointVector joints = robot.known_state().desired_joints;
    joints[0] += by;
    joints[1] += by / 4;
    return joints;
  }

  /// Moves both arms by as much, at a speed at which the motion takes some fifty steps.
  Outcome move(double by) {
    Wait({left, right}, {}, ElapsedSteps{0});
    return Move({left, right}, {},
                Together{JointLine{left, moved(left, by), 0.5}, JointLine{right, moved(right, by), 0.5}});
  }

  /// The difference between what the two arms have done since the start.
  double difference() const { return (left.state().desired_joints - right.state().desired_joints).norm(); }

  void show(const char* what) {
    wait_for_all();
    const auto took = take<Took>("left");
    std::printf("%s: %llu steps, %llu plans, %s; difference %.9f\n", what,
                static_cast<unsigned long long>(took ? took->steps : 0),
                static_cast<unsigned long long>(took ? took->plans : 0),
                took && took->ended ? "with the MP" : "on its own", difference());
  }

  void refused(const std::function<void()>& attempt) {
    try {
      attempt();
      std::printf("not refused\n");
    } catch (const Error& error) {
      std::printf("refused: %s\n", error.what());
    }
  }

  void mirror() {
    start("left", Mirror{});
    const Outcome end = move(0.3);
    std::printf("%llu steps, skew %llu\n", static_cast<unsigned long long>(end.steps),
                static_cast<unsigned long long>(end.skew));
    show("mirrored");
    move(-0.3);
    std::printf("transparent: difference %.9f\n", difference());
  }

  void corrected() {
    start("left", Correct{0.004});
    Wait({left, right}, {}, ElapsedSteps{0});
    const Pose from = left.state().desired_pose, aim = Pose{from * Eigen::Translation3d{0, 0, -0.05}};
    Move({left, right}, {}, CartesianLine{left, aim, PathLimits{.speed = 0.01, .acceleration = 0.05}});
    const Eigen::Vector3d off = aim.inverse() * left.state().desired_pose.translation();
    wait_for_all();
    std::printf("off by %.3f mm, %.3f mm in z\n", 1000 * off.norm(), 1000 * off.z());
  }

  void first() {
    start("left", Mirror{.ends_after = 20});
    move(0.3);
    show("ended first");
  }

  void error() {
    start("left", Mirror{.refused = true});
    const Tick before = tick();
    refused([this] { move(0.3); });
    std::printf("seen after %s ticks\n", tick() - before < 200 ? "few" : "many");
    refused([this] { wait_for_all(); });
    start("left", Mirror{.throws_after = 15});
    refused([this] { move(0.3); });
    std::printf("moving: %d %d\n", !left.state().at_rest(), !right.state().at_rest());
    refused([this] { wait_for_all(); });
    move(0.1);
    std::printf("transparent\n");
  }

  void stay() {
    start("left", Mirror{.stays = true});
    move(0.2);
    Wait({left, right}, {}, ElapsedSteps{10});
    left.set_tool(left.kinematics().tool());
    move(-0.1);
    end_motion("left");
    show("stayed");
  }

  void busy() {
    start("left", Rest{100});
    sleep_until(tick() + 25);  // the ECP answers while it runs
    refused([this] { move(0.1); });
    wait_for_all();
  }

  /// Without a force sensor there is nothing to give way to.
  void comply() {
    Wait({left, right}, {}, ElapsedSteps{0});
    Together carry{JointLine{left, moved(left, 0.2), 0.5}, JointLine{right, moved(right, 0.2), 0.5}};
    start("left", Comply{});
    start("right", Comply{});
    Move({left, right}, {}, carry);
    wait_for_all({"left", "right"});
    std::printf("carried, difference %.9f\n", difference());
  }

  void weave() {
    Wait({left, right}, {}, ElapsedSteps{0});
    const Pose aim = left.state().desired_pose * Eigen::Translation3d{0, 0, -0.05};
    start("left", Weave{});
    double widest = 0;
    CartesianLine line{left, aim, PathLimits{.speed = 0.02, .acceleration = 0.05}};
    line.until(When{"never", [&] {
                      const Eigen::Vector3d off = aim.inverse() * left.state().desired_pose.translation();
                      widest = std::max(widest, std::abs(off.y()));
                      return false;
                    }});
    Move({left}, {}, line);
    wait_for_all();
    std::printf("widest %.1f mm\n", 1000 * widest);
  }
};

}  // namespace
}  // namespace mrroc::test

MRROC_MP(mrroc::test::CoordinatedMoves)
