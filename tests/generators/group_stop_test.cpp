// Two arms that carry a bar, each with its EDP core, are stopped at random ticks: the bar is neither bent nor pulled.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <random>

#include "generators/loopback_cell.hpp"
#include "geometry/rigid_motion.hpp"
#include "mrroc/generators/cooperative_motion.hpp"
#include "mrroc/generators/joint_line.hpp"
#include "mrroc/generators/together.hpp"
#include "mrroc/move.hpp"
#include "mrroc/stopped.hpp"
#include "repetitions.hpp"
#include "robots/irb6/irb6_model.hpp"

namespace mrroc::test::group_stop_test {
namespace {

constexpr double kTicks = 1500;    // in which the arms surely move
constexpr Tick kStopTicks = 1000;  // more than their stop takes

/// At a wrist that meets nothing, but for a blow.
class Blow : public edp::ForceSensor {
 public:
  const Pose& mount() const noexcept override { return mount_; }
  edp::WrenchReading read(Tick tick, const Pose*) noexcept override {
    edp::WrenchReading reading;
    reading.error = ErrorCode::none;
    if (tick == at) reading.wrench[2] = 200;
    return reading;
  }
  void bias() noexcept override {}
  void carry(const Load&) noexcept override {}
  Tick at = kNever;

 private:
  Pose mount_ = Pose::Identity();
};

/// The bar is held at its ends, in the middle of the workspace.
class Carriers : public LoopbackCell {
 public:
  explicit Carriers(Blow* blow = nullptr) : LoopbackCell({load_irb6().front(), load_irb6().front()}, blow) {
    bases_[0] = Eigen::Translation3d(0, 0.45, 0.7);
    bases_[1] = Eigen::Translation3d(0, -0.45, 0.7);
    const JointVector middle = (JointVector(6) << 0, -1.5, 0.2, -0.2, 4.7, 1.6).finished();
    Move({robot(0), robot(1)}, {}, Together{JointLine{robot(0), middle, 1.0}, JointLine{robot(1), middle, 1.0}});
    held_ = between();
    on_tick = [this] {
      if (!edp::has_power(seen(0).state)) return;  // its set-point is where its brakes hold it
      const Pose error = held_.inverse() * between();
      bent_ = std::max(bent_, error.translation().norm());
      turned_ = std::max(turned_, rotation_vector(error.linear()).norm());
    };
  }

  OperatorRequest operator_request() noexcept override {
    return tick() < stop_at ? OperatorRequest::none : tick() < stop_until ? request : OperatorRequest::none;
  }
  OperatorRequest request = OperatorRequest::none;
  Tick stop_at = kNever, stop_until = kNever;

  std::vector<CooperatingArm> arms() { return {{&robot(0), bases_[0]}, {&robot(1), bases_[1]}}; }
  std::vector<Pose> path(std::mt19937_64& random) const {
    std::uniform_real_distribution<double> way(-0.08, 0.08), turn(-0.15, 0.15);
    Pose object = bases_[0] * tool(0);
    object.translation() = (object.translation() + (bases_[1] * tool(1)).translation()) / 2;
    std::vector<Pose> poses{object};
    for (int i = 0; i < 3; ++i)
      poses.push_back(Eigen::Translation3d(way(random), way(random), way(random)) * object *
                      pose_from_rpy({0, 0, 0}, {turn(random), turn(random), turn(random)}));
    return poses;
  }
  double bent() const { return bent_; }      ///< m, at most so far
  double turned() const { return turned_; }  ///< rad
  std::uint64_t stops() const { return seen(0).counters.stops + seen(1).counters.stops; }

 private:
  Pose tool(std::size_t i) const { return ToolKinematics(*model_).direct(seen(i).desired.position); }
  Pose between() const { return (bases_[0] * tool(0)).inverse() * bases_[1] * tool(1); }

  std::shared_ptr<const RobotModel> model_ = load_irb6().front();
  Pose bases_[2];
  Pose held_;
  double bent_ = 0, turned_ = 0;
};

constexpr CooperativeLimits kFast{
    .speed = 0.04, .acceleration = 0.2, .angular_speed = 0.06, .angular_acceleration = 0.3};

/// Commands that come too late once, from a given tick on.
class Late : public CooperativeMotion {
 public:
  Late(Carriers& cell, const std::vector<Pose>& path, Tick from, Tick delay)
      : CooperativeMotion(cell.arms(), path, kFast), cell_(&cell), from_(from), delay_(delay) {}
  void next_state() override {
    CooperativeMotion::next_state();
    if (cell_->tick() < from_) return;
    from_ = kNever;
    cell_->sleep_until(cell_->tick() + delay_);
  }

 private:
  Carriers* cell_;
  Tick from_, delay_;
};

struct Worst {
  double bent = 0, turned = 0;
  std::uint64_t stops = 0;
  void add(const Carriers& cell) {
    bent = std::max(bent, cell.bent());
    turned = std::max(turned, cell.turned());
    stops += cell.stops();
  }
  void print(const char* kind) const {
    std::printf("%s: at most %.3f mm, %.3f mrad\n", kind, 1000 * bent, 1000 * turned);
  }
  void expect_small() const {
    EXPECT_LT(bent, 0.001);
    EXPECT_LT(turned, 0.001);
  }
};

Worst after_late_commands(int seeds, bool each_on_its_own) {
  Worst worst;
  for (int seed = 1; seed <= seeds; ++seed) {
    std::mt19937_64 random(static_cast<std::uint64_t>(seed));
    Carriers cell;
    cell.each_on_its_own = each_on_its_own;
    const std::vector<Pose> path = cell.path(random);
    const Tick from = cell.tick() + std::uniform_int_distribution<Tick>(20, kTicks)(random);
    Late motion(cell, path, from, std::uniform_int_distribution<Tick>(15, 400)(random));
    Move({cell.robot(0), cell.robot(1)}, {}, motion);
    worst.add(cell);
  }
  worst.print(each_on_its_own ? "late command, each arm on its own" : "late command");
  return worst;
}

TEST(GroupStop, LateCommandsDoNotBendTheBar) {
  const int seeds = tries(50, 200);
  const Worst worst = after_late_commands(seeds, false);
  worst.expect_small();
  EXPECT_GT(worst.stops, static_cast<std::uint64_t>(2 * seeds / 5));
  EXPECT_GT(after_late_commands(20, true).bent, 10 * worst.bent);
}

TEST(GroupStop, PausesDoNotBendTheBar) {
  Worst worst;
  for (int seed = 1; seed <= tries(50, 200); ++seed) {
    std::mt19937_64 random(static_cast<std::uint64_t>(seed));
    Carriers cell;
    CooperativeMotion motion(cell.arms(), cell.path(random), kFast);
    cell.request = OperatorRequest::pause;
    cell.stop_at = cell.tick() + std::uniform_int_distribution<Tick>(20, kTicks)(random);
    cell.stop_until = cell.stop_at + std::uniform_int_distribution<Tick>(1, 800)(random);
    Move({cell.robot(0), cell.robot(1)}, {}, motion);
    worst.add(cell);
  }
  worst.print("pause");
  worst.expect_small();
  EXPECT_EQ(worst.stops, 0u);
}

TEST(GroupStop, EndsOfTheTaskAndOfItsMotionDoNotBendTheBar) {
  for (const OperatorRequest request : {OperatorRequest::stop, OperatorRequest::end_motion}) {
    Worst worst;
    for (int seed = 1; seed <= tries(25, 200); ++seed) {
      std::mt19937_64 random(static_cast<std::uint64_t>(seed));
      Carriers cell;
      CooperativeMotion motion(cell.arms(), cell.path(random), kFast);
      cell.request = request;
      cell.stop_at = cell.tick() + std::uniform_int_distribution<Tick>(20, kTicks)(random);
      try {
        Move({cell.robot(0), cell.robot(1)}, {}, motion);
      } catch (const Stopped&) {
        EXPECT_EQ(request, OperatorRequest::stop);
      }
      EXPECT_TRUE(cell.robot(0).state().at_rest() && cell.robot(1).state().at_rest()) << "seed " << seed;
      worst.add(cell);
    }
    worst.print(request == OperatorRequest::stop ? "stop" : "end of the motion");
    worst.expect_small();
  }
}

TEST(GroupStop, ForceLimitOfOneArmDoesNotBendTheBar) {
  Worst worst;
  const int seeds = tries(50, 200);
  int met = 0;
  for (int seed = 1; seed <= seeds; ++seed) {
    std::mt19937_64 random(static_cast<std::uint64_t>(seed));
    Blow blow;
    Carriers cell(&blow);
    CooperativeMotion motion(cell.arms(), cell.path(random), kFast);
    blow.at = cell.tick() + std::uniform_int_distribution<Tick>(20, kTicks)(random);
    try {
      Move({cell.robot(0), cell.robot(1)}, {}, motion);
    } catch (const NonFatalError& error) {
      EXPECT_EQ(error.code(), ErrorCode::force_limit) << "seed " << seed;
      ++met;
    }
    cell.sleep_until(cell.tick() + kStopTicks);
    EXPECT_TRUE(cell.seen(0).desired.at_rest() && cell.seen(1).desired.at_rest()) << "seed " << seed;
    worst.add(cell);
  }
  worst.print("force limit of one arm");
  worst.expect_small();
  EXPECT_GT(met, 4 * seeds / 5);
}

/// `stop` is done to one arm at a random tick.
Worst after_stops_of_one(const char* kind, int seeds, void (Carriers::*stop)(), bool unknown_to_each_other) {
  Worst worst;
  for (int seed = 1; seed <= seeds; ++seed) {
    std::mt19937_64 random(static_cast<std::uint64_t>(seed));
    Carriers cell;
    cell.unknown_to_each_other = unknown_to_each_other;
    CooperativeMotion motion(cell.arms(), cell.path(random), kFast);
    const Tick when = cell.tick() + std::uniform_int_distribution<Tick>(20, kTicks)(random);
    const auto measure = cell.on_tick;
    cell.on_tick = [&] {
      measure();
      if (cell.tick() == when) (cell.*stop)();
    };
    EXPECT_THROW(Move({cell.robot(0), cell.robot(1)}, {}, motion), Error) << "seed " << seed;
    cell.sleep_until(cell.tick() + kStopTicks);
    EXPECT_TRUE(cell.seen(1).desired.at_rest()) << "seed " << seed;
    EXPECT_TRUE(cell.seen(1).enabled()) << "seed " << seed;
    EXPECT_FALSE(cell.seen(0).enabled()) << "seed " << seed;
    worst.add(cell);
  }
  worst.print(kind);
  return worst;
}

TEST(GroupStop, ArmThatIsSwitchedOffDoesNotBendTheBar) {
  const int seeds = tries(50, 200);
  const Worst worst = after_stops_of_one("one arm switched off", seeds, &Carriers::switch_off, false);
  worst.expect_small();
  EXPECT_LT(20 * worst.bent,
            after_stops_of_one("the same, the other one at the next step", seeds, &Carriers::switch_off, true).bent);
}

/// It has the shortest stop, the other one that on their common way.
TEST(GroupStop, EmergencyStopOfOneArmStopsTheOtherOne) {
  const Worst worst =
      after_stops_of_one("emergency stop of one arm", tries(50, 200), &Carriers::press_emergency_stop, false);
  EXPECT_LT(worst.bent, 0.006);
  EXPECT_LT(worst.turned, 0.006);
}

}  // namespace
}  // namespace mrroc::test::group_stop_test
