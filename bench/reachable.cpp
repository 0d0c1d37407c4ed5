// How many reachable poses a motion in joint space refuses, and the cost of choosing among all branches.
//   reachable [--postures n] [--seed n]
//
// For every robot of robots/: poses of random postures within joint and motor limits, asked for as JointLine does
// (posture_of) from home and from another random posture; then the poses of singular postures (each revolute joint in
// turn at a multiple of a right angle). Both times are of a posture that may be sent, joint and motor limits judged:
// "single" of the branch that is near (ToolKinematics::follow, within_limits), "all" of the best of all branches
// (nearest_posture), for poses of which the former is within the limits; processor time of this thread, the ratio is
// that of the medians.
// The exit code is 1 when a robot refuses more than the bar, or is slower than the bar.
#include <time.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <numbers>
#include <random>

#include "bench/kinematics/robots.hpp"
#include "language/joints/joint_targets.hpp"
#include "robots/common/one_robot_task.hpp"

namespace mrroc::bench {
namespace {

constexpr double kRefusedBar = 0.005;
constexpr double kTimeBar = 1.5;
constexpr int kCalls = 20;  // timed together

double processor_us() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return 1e6 * static_cast<double>(time.tv_sec) + 1e-3 * static_cast<double>(time.tv_nsec);
}

template <class Call>
double us_per_call(Call&& call) {
  const double begin = processor_us();
  for (int i = 0; i < kCalls; ++i) call();
  return (processor_us() - begin) / kCalls;
}

double median(std::vector<double>& values) {
  if (values.empty()) return 0;
  std::nth_element(values.begin(), values.begin() + std::ssize(values) / 2, values.end());
  return values[values.size() / 2];
}

class Reach {
 public:
  Reach(const RobotModels& models, std::uint64_t seed)
      : model_(*models.front()), task_("arm", model_.parameters().type), robot_(task_, "arm", models), random_(seed) {}

  bool run(int count) {
    int home = 0, other = 0, singular = 0, singular_count = 0;
    std::vector<double> single, all;
    for (int i = 0; i < count; ++i) {
      const Pose pose = kinematics_.direct(posture());
      if (!taken(pose, model_.parameters().home)) ++home;
      const JointVector near = posture();
      if (!taken(pose, near)) ++other;
      measure(pose, model_.parameters().home, single, all);
    }
    for (int i = 0; i < count / 20; ++i) {
      JointVector joints = posture();
      for (int k = 0; k < joints.size(); ++k) {
        JointVector straight = joints;
        straight[k] = std::round(straight[k] / (std::numbers::pi / 2)) * (std::numbers::pi / 2);
        if (model_.joint_period(k) == 0 || !within_limits(model_, straight)) continue;
        JointVector found;
        const Pose pose = kinematics_.direct(straight);
        if (kinematics_.follow(pose, posture(), found) != ErrorCode::singular) continue;
        ++singular_count;
        if (taken(pose, model_.parameters().home)) ++singular;
      }
    }
    const double one = median(single), every = median(all), ratio = one > 0 ? every / one : 0;
    const bool pass = home <= kRefusedBar * count && other <= kRefusedBar * count && ratio <= kTimeBar;
    std::printf("%-20s %8d %9d %9d %9d/%-6d %8.2f %8.2f %6.2f  %s\n", model_.parameters().type.c_str(), count, home,
                other, singular, singular_count, one, every, ratio, pass ? "pass" : "FAIL");
    return pass;
  }

 private:
  JointVector posture() {
    JointVector joints(model_.joint_count());
    do {
      for (int i = 0; i < joints.size(); ++i) {
        const AxisParameters& axis = model_.parameters().axes[static_cast<std::size_t>(i)];
        const double low = std::isfinite(axis.position_min) ? axis.position_min : -std::numbers::pi;
        const double high = std::isfinite(axis.position_max) ? axis.position_max : std::numbers::pi;
        joints[i] = std::uniform_real_distribution<double>(low, high)(random_);
      }
    } while (!within_limits(model_, joints));
    return joints;
  }

  bool taken(const Pose& pose, const JointVector& near) {
    try {
      const Posture found = posture_of(robot_, pose, near, "target");
      return within_limits(model_, found.joints) && kinematics_.direct(found.joints).isApprox(pose, 1e-8);
    } catch (const NonFatalError&) {
      return false;
    }
  }

  void measure(const Pose& pose, const JointVector& near, std::vector<double>& single, std::vector<double>& all) {
    JointVector joints;
    if (kinematics_.follow(pose, near, joints) != ErrorCode::none || !within_limits(model_, joints)) return;
    bool sent = true;
    single.push_back(us_per_call([&] {
      sent = kinematics_.follow(pose, near, joints) == ErrorCode::none && within_limits(model_, joints) && sent;
    }));
    all.push_back(us_per_call([&] { joints = nearest_posture(kinematics_, pose, near).joints; }));
    if (!sent) throw std::logic_error("the same call gave another result");
  }

  const RobotModel& model_;
  OneRobotTask task_;
  Robot robot_;
  ToolKinematics kinematics_{model_};
  std::mt19937_64 random_;
};

int run(int count, std::uint64_t seed) {
  std::printf("robot                postures   refused from       singular     single      all  ratio\n");
  std::printf("                               home   posture        taken      us p50   us p50\n");
  bool pass = true;
  for (const RobotModels& models : load_robots()) pass = Reach(models, seed).run(count) && pass;
  return pass ? 0 : 1;
}

}  // namespace
}  // namespace mrroc::bench

int main(int argc, char** argv) {
  int postures = 20000;
  std::uint64_t seed = 1;
  CLI::App app{"Reachable poses that a motion in joint space refuses, and the time of an inverse"};
  app.add_option("--postures", postures, "per robot")->check(CLI::PositiveNumber);
  app.add_option("--seed", seed, "of the postures");
  CLI11_PARSE(app, argc, argv);
  try {
    return mrroc::bench::run(postures, seed);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
  }
}
