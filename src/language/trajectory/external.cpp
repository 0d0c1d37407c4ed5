#include "mrroc/generators/external.hpp"

#include <cstdio>
#include <exception>
#include <utility>

#include "language/trajectory/trajectory_follower.hpp"
#include "mrroc/task.hpp"
#include "mrroc/trajectory_link.hpp"

namespace mrroc {

namespace {

constexpr int kPartsPerStep = 8;

template <class... Values>
FixedText<127> text_of(const char* format, Values... values) noexcept {
  char text[128];
  std::snprintf(text, sizeof text, format, values...);
  return FixedText<127>(text);
}

}  // namespace

struct External::State {
  Robot* robot;
  FixedText<kNameLength> name;
  TrajectoryLink* link;
  TrajectoryFollower follower;
  JointTrajectory incoming;
  TrajectoryPart part;
  std::uint64_t receiving = 0, following = 0;  // numbers of trajectories; 0: none
  bool open = false, paused = false;
  TrajectoryState end = TrajectoryState::arrived;  // of the braking trajectory
  FixedText<127> why;

  explicit State(Robot& moved)
      : robot(&moved), name(moved.name()), link(moved.task().trajectory_link()), follower(moved) {
    incoming.reserve(moved.parameters().axes.size());
  }

  void report(std::uint64_t trajectory, TrajectoryState state, const FixedText<127>& text = {}) {
    TrajectoryReport report;
    report.robot = name;
    report.trajectory = trajectory;
    report.state = state;
    report.text = text;
    report.tick = robot->state().tick;
    link->report(report);
  }

  void refuse(const FixedText<127>& text) {
    report(std::exchange(receiving, 0), TrajectoryState::refused, text);
    incoming.clear();
  }

  void take_parts() {
    for (int i = 0; link != nullptr && i < kPartsPerStep && link->take(name, part); ++i) {
      if (part.order == TrajectoryOrder::cancel)
        cancel(part.trajectory);
      else
        receive();
    }
  }

  /// A later trajectory that was refused does not keep an earlier one from being cancelled.
  void cancel(std::uint64_t trajectory) {
    if (receiving != 0 && receiving <= trajectory) {
      report(std::exchange(receiving, 0), TrajectoryState::cancelled);
      incoming.clear();
    }
    if (following != 0 && following <= trajectory) brake_to(TrajectoryState::cancelled, {});
  }

  void receive() {
    if (part.begin == 0) {
      if (receiving != 0) refuse(FixedText<127>("another trajectory came before its last part"));
      receiving = part.trajectory;
    }
    if (part.trajectory != receiving) return;
    if (!incoming.receive(part.size, part.begin, {part.numbers.data(), part.count}))
      return refuse(FixedText<127>("a part of it is missing"));
    if (!incoming.complete()) return;
    if (const char* const problem = incoming.problem(robot->parameters().axes.size()))
      return refuse(FixedText<127>(problem));
    if (const ErrorReport why_not = follower.check(incoming); why_not.error_class != ErrorClass::none)
      return refuse(FixedText<127>(why_not.detail.view()));
    if (following != 0) report(following, TrajectoryState::cancelled, FixedText<127>("replaced by another trajectory"));
    follower.begin(incoming);
    incoming.clear();
    following = std::exchange(receiving, 0);
    end = TrajectoryState::arrived;
    report(following, TrajectoryState::begun);
  }

  void brake_to(TrajectoryState state, const FixedText<127>& text) noexcept {
    if (end != TrajectoryState::arrived) return;
    end = state;
    why = text;
    follower.brake();
  }

  /// Whether the trajectory has ended by what is known before this step.
  void judge() {
    double distance = 0;
    if (end != TrajectoryState::arrived) {
      if (follower.at_rest() || follower.at_end()) report(std::exchange(following, 0), end, why);
      return;
    }
    if (paused) return;
    if (follower.at_end() && robot->state().at_rest()) {
      const int axis = follower.off_goal(distance);
      const JointTrajectory& all = follower.trajectory();
      const double limit = all.goal_time() > 0 ? all.goal_time() : JointTrajectory::kGoalTime;
      if (axis < 0)
        report(std::exchange(following, 0), TrajectoryState::arrived);
      else if (follower.time() > all.duration() + limit)
        report(std::exchange(following, 0), TrajectoryState::goal_tolerance, distance_text(axis, distance, true));
      return;
    }
    if (const int axis = follower.off_path(distance); axis >= 0)
      brake_to(TrajectoryState::path_tolerance, distance_text(axis, distance, false));
  }

  FixedText<127> distance_text(int axis, double distance, bool goal) const noexcept {
    const auto index = static_cast<std::size_t>(axis);
    const JointTrajectory& all = follower.trajectory();
    return text_of("joint %s is %.4g from it at %.4g s, tolerance %.4g", robot->parameters().axes[index].name.c_str(),
                   distance, follower.time(), goal ? all.goal_tolerance(index) : all.path_tolerance(index));
  }
};

External::External(Robot& robot) : Generator("External"), state_(std::make_unique<State>(robot)) {}
External::~External() = default;
External::External(External&&) noexcept = default;
External& External::operator=(External&&) noexcept = default;

void External::start() {
  State& s = *state_;
  s.following = s.receiving = 0;
  s.incoming.clear();
  s.paused = false;
  std::uint64_t last = 0;
  while (s.link != nullptr && s.link->take(s.name, s.part)) {
    if (s.part.order == TrajectoryOrder::follow && s.part.trajectory != last)
      s.report(s.part.trajectory, TrajectoryState::refused, FixedText<127>("the task did not yield the robot"));
    last = s.part.trajectory;
  }
  s.open = s.link != nullptr;
  if (s.open) s.report(0, TrajectoryState::yielded);
}

void External::resume() {
  State& s = *state_;
  s.paused = false;
  if (s.following == 0) return;
  if (s.end != TrajectoryState::arrived)
    s.report(std::exchange(s.following, 0), s.end, s.why);
  else
    s.follower.go_on();
}

bool External::brake() {
  State& s = *state_;
  s.paused = true;
  if (s.following == 0) return false;
  s.follower.brake();
  return true;
}

void External::next_state() {
  State& s = *state_;
  if (!s.paused) s.take_parts();
  if (s.following != 0) s.judge();
  if (s.following != 0) s.follower.step();
}

void External::finish() noexcept {
  State& s = *state_;
  if (!std::exchange(s.open, false)) return;
  try {
    if (s.receiving != 0) s.report(std::exchange(s.receiving, 0), TrajectoryState::taken_back);
    if (s.following != 0) s.report(std::exchange(s.following, 0), TrajectoryState::taken_back);
    s.report(0, TrajectoryState::withdrawn);
  } catch (const std::exception&) {  // the run ends with the link
  }
}

}  // namespace mrroc
