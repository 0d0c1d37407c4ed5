#include "mrroc/generators/replay.hpp"

#include <cmath>
#include <ruckig/ruckig.hpp>

#include "core/require.hpp"
#include "geometry/natural_spline.hpp"
#include "geometry/near_places.hpp"
#include "language/joints/joint_leg.hpp"
#include "language/joints/joint_targets.hpp"
#include "language/motion_check.hpp"
#include "mrroc/task.hpp"

namespace mrroc {

namespace {

constexpr double kLegSpeed = 0.5;   // of the motion to a timed path, as JointLine's
constexpr double kRamp = 0.5;       // s of the ramp of ds/dt
constexpr double kSameTime = 0.02;  // s: points of one position that are closer in time are merged
constexpr int kRateHalvings = 40;
constexpr double kWholeRounding = 1e-9;  // macrosteps

/// Limits of s.
struct Pace {
  explicit Pace(double rate) : speed(rate), acceleration(rate / (0.5 * kRamp)), jerk(acceleration / (0.5 * kRamp)) {}
  double speed, acceleration, jerk;
};

/// Whether the joints stay within their limits at `sample` of the path, at any ds/dt up to the pace's: by the chain
/// rule, every term at its worst.
bool keeps_limits(const RobotParameters& parameters, const NaturalSpline::Sample& sample, const Pace& pace) {
  for (std::size_t i = 0; i < parameters.axes.size(); ++i) {
    const AxisParameters& axis = parameters.axes[i];
    const auto row = static_cast<Eigen::Index>(i);
    const double first = std::abs(sample.first[row]), second = std::abs(sample.second[row]),
                 third = std::abs(sample.third[row]), r = pace.speed;
    const double velocity = first * r, acceleration = second * r * r + first * pace.acceleration,
                 jerk = third * r * r * r + 3 * second * r * pace.acceleration + first * pace.jerk;
    if (velocity > kVelocityShare * axis.velocity_max || acceleration > kAccelerationShare * axis.acceleration_max ||
        jerk > kJerkShare * axis.jerk_max)
      return false;
  }
  return true;
}

}  // namespace

struct Replay::Plan {
  explicit Plan(const Robot& robot) : leg(robot), check(robot), step(robot.step_duration()) {}

  JointLeg leg;
  MotionCheck check;
  double step;
  bool on_leg = true;
  bool begun = false;  // the spline
  double time = 0;     // since the start of the leg or of the run along the spline, at the end of the commanded motion
  std::size_t point = 0;  // the next one
  NaturalSpline spline;
  double rate = 0;
  double s = 0;  // on the spline, at the same instant
  ruckig::Ruckig<1> ruckig;
  ruckig::InputParameter<1> input;
  ruckig::Trajectory<1> run;  // of s

  bool run_over() const { return time >= run.get_duration() - 1e-9; }

  void begin_run() {
    on_leg = false;
    begun = true;
    time = 0;
    plan_run();
  }

  /// From rest at s to rest at the end. Throws NonFatalError: the error with which the EDP would refuse the run.
  void plan_run() {
    const Pace pace(rate);
    input.minimum_duration.reset();
    input.current_position = {s};
    input.target_position = {spline.end()};
    input.max_velocity = {pace.speed};
    input.max_acceleration = {pace.acceleration};
    input.max_jerk = {pace.jerk};
    ruckig.calculate(input, run);
    const MotionCheck::States states = [this](double t) { return state(t); };
    double when = 0;
    if (!bad(check.check(states, run.get_duration(), when))) return;
    const double shortest = run.get_duration();
    for (const double slower : kSlower) {
      input.minimum_duration = std::ceil(slower * shortest / step - kWholeRounding) * step;
      ruckig.calculate(input, run);
      if (!bad(check.check(states, run.get_duration(), when))) return;
    }
    check.require(states, run.get_duration());
  }

  DesiredState state(double t) const {
    double place = 0, speed = 0, acceleration = 0;
    run.at_time(t, place, speed, acceleration);
    const NaturalSpline::Sample way = spline.at(place);
    return {way.position, way.first * speed, way.second * speed * speed + way.first * acceleration};
  }
};

Replay::Replay(Robot& robot, TaughtPath path, double speed)
    : Generator("Replay"), robot_(&robot), path_(std::move(path)), speed_(speed) {
  require_above_zero("Replay", "speed", speed);
  if (!path_.timed) check_speed(speed);
  const std::size_t least = path_.timed ? 2 : 1;
  require(path_.points.size() >= least, "Replay", "points", static_cast<double>(path_.points.size()),
          path_.timed ? "at least two" : "at least one");
  for (std::size_t i = 0; i < path_.points.size(); ++i) {
    const TaughtPoint& point = path_.points[i];
    const std::string what = "taught point " + std::to_string(i + 1);
    if (path_.timed && i > 0)
      require(point.time > path_.points[i - 1].time, "Replay", "time of a point", point.time,
              "later than the previous one");
    if (path_.space == TaughtPath::Space::joints)
      check_joints(robot, point.joints, what);
    else
      path_.points[i].pose = rigid_pose(robot, point.pose, what);
  }
}

Replay::~Replay() = default;
Replay::Replay(Replay&&) noexcept = default;
Replay& Replay::operator=(Replay&&) noexcept = default;

void Replay::find_joints() {
  JointVector near = robot_->known_state().desired_joints;
  for (std::size_t i = 0; i < path_.points.size(); ++i) {
    TaughtPoint& point = path_.points[i];
    const std::string what = "taught point " + std::to_string(i + 1);
    point.joints = posture_of(*robot_, point.pose, near, what).joints;
    near = point.joints;
  }
}

void Replay::start() {
  if (path_.space == TaughtPath::Space::poses) find_joints();
  plan_ = std::make_unique<Plan>(*robot_);
  Plan& plan = *plan_;
  if (path_.timed) {
    std::vector<double> times;
    std::vector<JointVector> positions;
    const auto near = [this](std::size_t a, std::size_t b) {
      const TaughtPoint &first = path_.points[a], &second = path_.points[b];
      return std::abs(second.time - first.time) < kSameTime &&
             (second.joints - first.joints).lpNorm<Eigen::Infinity>() < kSamePlace;
    };
    for (const std::size_t i : distinct_places(path_.points.size() - 1, near)) {
      times.push_back(path_.points[i].time);
      positions.push_back(path_.points[i].joints);
    }
    plan.spline = NaturalSpline(times, positions);
    plan.s = plan.spline.begin();
    const auto possible = [&](double rate) {
      // the shares of the limits leave a margin between the samples
      for (std::size_t i = 1; i < times.size(); ++i)
        for (const double share : {0.0, 0.25, 0.5, 0.75, 0.999999}) {
          const double t = times[i - 1] + share * (times[i] - times[i - 1]);
          if (!keeps_limits(robot_->parameters(), plan.spline.at(t), Pace(rate))) return false;
        }
      return true;
    };
    plan.rate = speed_;
    double low = 0, high = speed_;
    for (int i = 0; i < kRateHalvings && !possible(plan.rate); ++i) {
      high = plan.rate;
      plan.rate = low = 0.5 * high;
    }
    for (int i = 0; i < 10 && high > plan.rate; ++i) {
      const double middle = 0.5 * (low + high);
      (possible(middle) ? low : high) = middle;
      plan.rate = low;
    }
    plan.plan_run();  // refused before anything moves
  } else {
    for (std::size_t i = 1; i < path_.points.size(); ++i)
      plan.leg.plan(path_.points[i - 1].joints, path_.points[i].joints, speed_);
  }
  resume();
}

void Replay::resume() {
  Plan& plan = *plan_;
  plan.on_leg = true;
  plan.time = 0;
  const JointVector& target = path_.timed ? plan.spline.at(plan.s).position
                                          : path_.points[std::min(plan.point, path_.points.size() - 1)].joints;
  plan.leg.plan(target, path_.timed ? kLegSpeed : speed_);
}

bool Replay::terminal_condition() {
  Plan& plan = *plan_;
  if (plan.on_leg && plan.leg.over(plan.time)) {
    if (path_.timed) {
      plan.begin_run();
    } else {
      if (plan.point < path_.points.size()) ++plan.point;
      if (plan.point < path_.points.size()) resume();
    }
  }
  if (!path_.timed) return plan.point >= path_.points.size();
  return !plan.on_leg && plan.run_over();
}

void Replay::next_state() {
  Plan& plan = *plan_;
  RobotCommand& command = robot_->command();
  plan.time += robot_->step_duration();
  if (plan.on_leg) return plan.leg.write(plan.time, command);
  command.kind = CommandKind::joint;
  if (plan.run_over()) {
    plan.s = plan.spline.end();
    command.joints = path_.points.back().joints;
    return;  // at rest
  }
  double speed = 0, acceleration = 0;
  plan.run.at_time(plan.time, plan.s, speed, acceleration);
  const NaturalSpline::Sample way = plan.spline.at(plan.s);
  command.joints = way.position;
  command.joint_velocity = way.first * speed;
  command.joint_acceleration = way.second * speed * speed + way.first * acceleration;
}

double Replay::rate() const noexcept { return plan_ ? plan_->rate : 0; }

std::size_t Replay::point() const noexcept {
  if (!plan_) return 0;
  if (!path_.timed) return plan_->point;
  std::size_t reached = 0;
  while (plan_->begun && reached < path_.points.size() && path_.points[reached].time <= plan_->s) ++reached;
  return reached;
}

}  // namespace mrroc
