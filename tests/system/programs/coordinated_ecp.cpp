// An arm that takes part in the Moves of its MP: equation (11).
#include <cmath>

#include "mrroc/ecp.hpp"
#include "mrroc/robots/irb6.hpp"
#include "system/programs/coordinated.hpp"

using namespace mrroc;

namespace mrroc::test {
namespace {

class Mirroring : public Coordinated {
 public:
  Mirroring(Superior& superior, Robot& robot, const Mirror& mirror)
      : Coordinated("Mirroring", superior), robot_(robot), mirror_(mirror) {
    if (mirror.stays) stay();
  }
  void start() override { ++plans; }
  void resume() override { ++plans; }
  bool terminal_condition() override {
    return Coordinated::terminal_condition() || (mirror_.ends_after != 0 && steps >= mirror_.ends_after);
  }
  void next_state() override {
    if (++steps == mirror_.throws_after) throw NonFatalError{"it was to throw"};
    robot_.command() = superior().command();
    if (mirror_.refused && steps == 5) robot_.command().joints[0] += 0.1;
  }
  std::uint64_t steps = 0, plans = 0;

 private:
  Robot& robot_;
  Mirror mirror_;
};

/// Moves as the MP does, and weaves about its straight path: along the tool's y axis, by 2 mm and back once in 3 s.
class Weaving : public Coordinated {
 public:
  Weaving(Superior& superior, Robot& robot) : Coordinated("Weaving", superior), robot_(&robot) {}
  void start() override { time_ = 0; }
  void next_state() override {
    RobotCommand command = superior().command();
    if (command.kind != CommandKind::pose) {  // a joint motion first brings the arm to rest
      time_ = 0;
      robot_->command() = command;
      return;
    }
    time_ += robot_->step_duration();
    command.twist.head<3>() += command.pose.linear().col(1) * (kWide * kFast * std::sin(kFast * time_));
    command.pose.translate(Eigen::Vector3d(0, kWide * (1 - std::cos(kFast * time_)), 0));
    command.twist_acceleration.resize(0);  // the macrostep's mean
    robot_->command() = command;
  }

 private:
  static constexpr double kWide = 0.001, kFast = 2.1;  // m, rad/s
  Robot* robot_;
  double time_ = 0;  // s, since the MP's generator has planned
};

class Arm : public ecp::Task {
  Irb6 arm{*this};

 public:
  Arm() {
    on<Mirror>([this](const Mirror& mirror) {
      Mirroring mirroring{superior(), arm, mirror};
      const Outcome end = Move({arm}, {}, mirroring);
      tell(Took{end.steps, mirroring.plans, superior().ended()});
    });
    on<Correct>([this](const Correct& correct) {
      const auto correction = [&correct] { return Pose{Eigen::Translation3d{0, 0, correct.height}}; };
      const Outcome end = Move({arm}, {}, Corrected{superior(), arm, correction});
      tell(Took{end.steps, 1, superior().ended()});
    });
    on<Comply>([this](const Comply&) { Move({arm}, {}, Complying{superior(), arm}); });
    on<Weave>([this](const Weave&) { Move({arm}, {}, Weaving{superior(), arm}); });
    on<Rest>([this](const Rest& rest) { Wait({arm}, {}, ElapsedSteps{rest.steps}); });
  }
};

}  // namespace
}  // namespace mrroc::test

MRROC_ECP(mrroc::test::Arm)
