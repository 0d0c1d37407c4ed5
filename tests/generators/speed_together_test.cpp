// Several robots at the operator's speed, each with its EDP core: in step, also after late commands and pauses.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "generators/loopback_cell.hpp"
#include "mrroc/generators/joint_line.hpp"
#include "mrroc/generators/together.hpp"
#include "mrroc/move.hpp"
#include "robots/irb6/irb6_model.hpp"

namespace mrroc::test::speed_together_test {
namespace {

/// Moves the columns of two robots, the second one by -half the way of the first.
class InStep : public Generator {
 public:
  InStep(Robot& first, Robot& second) : Generator("InStep"), robots_{&first, &second} {}

  void start() override {
    for (std::size_t i = 0; i < 2; ++i) home_[i] = robots_[i]->known_state().desired_joints;
    begin_ = time_ = 0;
  }
  /// From where the robots rest.
  void resume() override {
    begin_ = (robots_[0]->state().desired_joints[0] - home_[0][0]) / kWay[0];
    time_ = 0;
  }
  bool terminal_condition() override { return time_ >= kDuration - 1e-9; }
  void next_state() override {
    time_ += robots_[0]->step_duration();
    const double u = time_ / kDuration, rest = 1 - begin_;
    const double way = begin_ + rest * u * u * u * (10 - u * (15 - 6 * u));
    const double speed = rest * 30 * u * u * (1 - u) * (1 - u) / kDuration;
    const double acceleration = rest * 60 * u * (1 - u) * (1 - 2 * u) / (kDuration * kDuration);
    for (std::size_t i = 0; i < 2; ++i) {
      RobotCommand& command = robots_[i]->command();
      command.kind = CommandKind::joint;
      command.joints = home_[i];
      command.joints[0] += kWay[i] * way;
      if (terminal_condition()) continue;
      command.joint_velocity = command.joint_acceleration = JointVector::Zero(home_[i].size());
      command.joint_velocity[0] = kWay[i] * speed;
      command.joint_acceleration[0] = kWay[i] * acceleration;
    }
  }

  static constexpr double kWay[] = {0.6, -0.3};  // rad
  static constexpr double kDuration = 4;         // s

 private:
  Robot* robots_[2];
  JointVector home_[2];
  double begin_ = 0, time_ = 0;
};

struct TwoArms : LoopbackCell {
  TwoArms() : LoopbackCell({load_irb6().front(), load_irb6().front()}) {
    home = seen(0).desired.position[0];
    on_tick = [this] {
      const double first = seen(0).desired.position[0] - home, second = seen(1).desired.position[0] - home;
      apart = std::max(apart, std::abs(first + 2 * second));
    };
  }
  OperatorRequest operator_request() noexcept override {
    return pauses && tick() < 2100 && tick() % 1500 > 400 && tick() % 1500 < 600 ? OperatorRequest::pause
                                                                                 : OperatorRequest::none;
  }
  bool pauses = false;
  double home = 0, apart = 0;
};

TEST(SpeedTogether, RobotsStayInStepDuringChangesAndPauses) {
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    std::mt19937_64 random(seed);
    std::vector<double> speeds(100);
    for (double& speed : speeds) speed = std::uniform_real_distribution<double>(0.05, 1)(random);
    TwoArms cell;
    cell.pauses = seed % 2 == 0;
    cell.speed_at = [&speeds](Tick now) { return speeds[now / 400 % speeds.size()]; };
    InStep motion(cell.robot(0), cell.robot(1));
    Move({cell.robot(0), cell.robot(1)}, {}, motion);
    EXPECT_LT(cell.apart, 1e-9) << "seed " << seed;
    for (std::size_t i = 0; i < 2; ++i) {
      EXPECT_TRUE(cell.robot(i).state().at_rest());
      EXPECT_NEAR(cell.robot(i).state().desired_joints[0], cell.home + InStep::kWay[i], 1e-12);
    }
  }
}

TEST(SpeedTogether, HalfTheSpeedTakesTwiceTheTime) {
  Tick took[2];
  for (const bool slow : {false, true}) {
    TwoArms cell;
    cell.speed_at = [slow](Tick) { return slow ? 0.5 : 1; };
    InStep motion(cell.robot(0), cell.robot(1));
    const Outcome outcome = Move({cell.robot(0), cell.robot(1)}, {}, motion);
    took[slow] = outcome.end_tick - outcome.start_tick;
    EXPECT_EQ(outcome.skew, 0u);
  }
  EXPECT_NEAR(static_cast<double>(took[1]), 2.0 * static_cast<double>(took[0]), 12);
}

TEST(SpeedTogether, LateCommandsLeadToRestWithinTheLimits) {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    std::mt19937_64 random(seed);
    TwoArms cell;
    const JointVector home = cell.seen(0).desired.position;
    JointVector there = home;
    there[0] += 0.3;
    std::vector<double> speeds(100);
    for (double& speed : speeds) speed = std::uniform_real_distribution<double>(0.05, 1)(random);
    cell.speed_at = [&speeds](Tick now) { return speeds[now / 300 % speeds.size()]; };
    int late = 0;
    struct Delayed : JointLine {
      using JointLine::JointLine;
      void next_state() override {
        JointLine::next_state();
        if (delay) delay();
      }
      std::function<void()> delay;
    };
    Delayed first{cell.robot(0), there, 0.7};
    JointLine second{cell.robot(1), there, 0.5};
    first.delay = [&] {
      if (std::uniform_int_distribution<int>(0, 20)(random) != 0) return;
      ++late;
      cell.sleep_until(cell.tick() + 30);
    };
    Move({cell.robot(0), cell.robot(1)}, {}, Together{first, second});
    for (std::size_t i = 0; i < 2; ++i) EXPECT_TRUE((cell.robot(i).state().desired_joints - there).isZero(1e-12));
    EXPECT_GT(late, 0) << "seed " << seed;
  }
}

}  // namespace
}  // namespace mrroc::test::speed_together_test
