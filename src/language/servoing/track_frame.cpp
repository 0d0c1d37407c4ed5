#include "mrroc/generators/track_frame.hpp"

#include <array>
#include <cmath>
#include <ruckig/ruckig.hpp>

#include "core/require.hpp"
#include "geometry/moving_pose.hpp"
#include "geometry/rigid_motion.hpp"
#include "language/macrostep_timing.hpp"
#include "language/servoing/frame_observer.hpp"
#include "language/tool_motion.hpp"
#include "mrroc/task.hpp"

namespace mrroc {

namespace {

constexpr double kFrameJerkRate = 10;      // 1/s: jerk per acceleration
constexpr double kCorrection = 4;          // 1/s
constexpr double kCorrectionDelay = 0.06;  // s
constexpr double kMostCorrection = 0.02;   // m
constexpr double kFrameDifference = 1e-4;  // s, for the derivatives of the path

using Coordinates = std::array<double, 6>;

Eigen::Vector3d clamped(const Eigen::Vector3d& vector, double length) {
  return vector.norm() > length ? Eigen::Vector3d(vector * (length / vector.norm())) : vector;
}

}  // namespace

/// The plan: the current leg of X, the estimate of F, the correction.
struct TrackFrame::Plan {
  Frame frame;
  std::vector<FramePoint> path;
  FrameLimits limits;
  int patience = 0;

  FrameObserver observer;
  ruckig::Ruckig<6> ruckig;
  ruckig::InputParameter<6> input;  // its current state is that of X at the leg's start
  ruckig::Trajectory<6> trajectory;
  std::size_t point = 0;
  double time = 0;    // since the leg's start, at the start of the coming macrostep
  double stayed = 0;  // s, at the point
  bool first = true;  // nothing has been commanded yet
  int lost = 0;
  Eigen::Vector3d error = Eigen::Vector3d::Zero();
  Eigen::Vector3d correction = Eigen::Vector3d::Zero(), correction_speed = Eigen::Vector3d::Zero(),
                  correction_rate = Eigen::Vector3d::Zero(), correction_jerk = Eigen::Vector3d::Zero();

  const Pose& target() const { return path[std::min(point, path.size() - 1)].pose; }
  bool arrived() const { return time >= trajectory.get_duration() - 1e-9; }
  bool over() const { return point >= path.size(); }

  /// Coordinates of X: position, and the turn from the leg's target.
  Coordinates coordinates(const Pose& x) const {
    const Eigen::Vector3d p = x.translation(), turn = rotation_vector(target().linear().transpose() * x.linear());
    return {p.x(), p.y(), p.z(), turn.x(), turn.y(), turn.z()};
  }

  void plan_leg(const Coordinates& position, const Coordinates& velocity, const Coordinates& acceleration) {
    input.target_position = coordinates(target());
    for (std::size_t i = 0; i < 6; ++i) {  // suppress motions of the size of rounding errors: Ruckig would plan them
      const bool there = std::abs(position[i] - input.target_position[i]) < 1e-12;
      input.current_position[i] = there ? input.target_position[i] : position[i];
      input.current_velocity[i] = std::abs(velocity[i]) < 1e-9 ? 0 : velocity[i];
      input.current_acceleration[i] = std::abs(acceleration[i]) < 1e-6 ? 0 : acceleration[i];
    }
    const ruckig::Result result = ruckig.calculate(input, trajectory);
    if (result != ruckig::Result::Working && result != ruckig::Result::Finished) {
      throw NonFatalError(ErrorCode::invalid_argument,
                          "no trajectory to the point in the moving frame (Ruckig result " +
                              std::to_string(static_cast<int>(result)) + ")");
    }
    time = 0;
    stayed = 0;
  }

  /// X `t` s after the leg's start.
  Pose relative(double t) const {
    Coordinates c{}, velocity{}, acceleration{};
    trajectory.at_time(std::max(t, 0.0), c, velocity, acceleration);
    Pose x = Pose::Identity();
    x.translation() << c[0], c[1], c[2];
    x.linear() = target().linear() * exp_rotation(Eigen::Vector3d(c[3], c[4], c[5]));
    return x;
  }

  /// Its rate is continuous: the EDP's polynomials would turn steps into large jerks.
  Eigen::Vector3d correction_at(double t) const {
    return correction + t * (correction_speed + t * (correction_rate / 2 + (t / 6) * correction_jerk));
  }

  /// The commanded tool `t` s after the macrostep's start.
  Pose tool(double t) const {
    Pose x = relative(time + t);
    x.translation() += correction_at(t);
    return observer.at(t).pose * x;
  }
};

TrackFrame::TrackFrame(Robot& robot, Frame frame, std::vector<FramePoint> path, const FrameLimits& limits, int patience)
    : Generator("TrackFrame"), robot_(&robot), plan_(std::make_unique<Plan>()) {
  if (!frame) throw NonFatalError(ErrorCode::invalid_argument, "TrackFrame without a function for the frame");
  if (path.empty()) throw NonFatalError(ErrorCode::invalid_argument, "TrackFrame without a point");
  for (const FramePoint& point : path) {
    if (!is_rigid(point.pose))
      throw NonFatalError(ErrorCode::invalid_argument, "TrackFrame: a point is not a rigid pose");
    require(point.dwell >= 0, "TrackFrame", "dwell", point.dwell, "a number of at least 0");
  }
  require(limits.speed > 0, "TrackFrame", "speed", limits.speed, "a number above 0");
  require(limits.acceleration > 0, "TrackFrame", "acceleration", limits.acceleration, "a number above 0");
  require(limits.angular_speed > 0, "TrackFrame", "angular speed", limits.angular_speed, "a number above 0");
  require(limits.angular_acceleration > 0, "TrackFrame", "angular acceleration", limits.angular_acceleration,
          "a number above 0");
  require(limits.tolerance > 0, "TrackFrame", "tolerance", limits.tolerance, "a number above 0");
  require_not_negative("TrackFrame", "patience", patience);
  plan_->frame = std::move(frame);
  plan_->path = std::move(path);
  plan_->limits = limits;
  plan_->patience = patience;
  ruckig::InputParameter<6>& input = plan_->input;
  input.synchronization = ruckig::Synchronization::Phase;
  for (std::size_t i = 0; i < 6; ++i) {
    input.max_velocity[i] = i < 3 ? limits.speed : limits.angular_speed;
    input.max_acceleration[i] = i < 3 ? limits.acceleration : limits.angular_acceleration;
    input.max_jerk[i] = kFrameJerkRate * input.max_acceleration[i];
  }
}

TrackFrame::TrackFrame(Robot& robot, Frame frame, const Pose& point, const FrameLimits& limits, int patience)
    : TrackFrame(robot, std::move(frame), std::vector<FramePoint>{{point, 0}}, limits, patience) {}

TrackFrame::~TrackFrame() = default;
TrackFrame::TrackFrame(TrackFrame&&) noexcept = default;
TrackFrame& TrackFrame::operator=(TrackFrame&&) noexcept = default;

std::size_t TrackFrame::point() const noexcept { return plan_->point; }
const Eigen::Vector3d& TrackFrame::error() const noexcept { return plan_->error; }

void TrackFrame::start() {
  plan_->point = 0;
  resume();
}

void TrackFrame::resume() {
  Plan& plan = *plan_;
  const RobotState& state = robot_->known_state();
  const std::optional<MovingFrame> measured = plan.frame();
  if (!measured) {
    throw NonFatalError(ErrorCode::sensor_not_ready, "no reading of the moving frame",
                        {robot_->task().process_name(), robot_->name(), 0, state.tick});
  }
  const double period = robot_->task().servo_period();
  // start of the first macrostep; next_state computes the same
  const Tick begin =
      std::max(state.desired_tick, robot_->task().tick() + (state.at_rest() ? MacrostepTiming::kFirstMargin : 0));
  const MovingFrame frame =
      measured->after((static_cast<double>(begin) - static_cast<double>(measured->tick)) * period);
  plan.observer.start(frame);
  plan.first = true;
  plan.lost = 0;
  plan.error.setZero();
  plan.correction.setZero();
  plan.correction_speed.setZero();
  plan.correction_rate.setZero();
  plan.correction_jerk.setZero();

  // the path of the tool in the frame at the present motion of both
  const MovingPose tool = desired_motion(*robot_);
  const auto moved = [&](double t) { return plan.coordinates(frame.after(t).pose.inverse() * tool.after(t)); };
  const Coordinates before = moved(-kFrameDifference), at = moved(0), after = moved(kFrameDifference);
  Coordinates velocity{}, acceleration{};
  for (std::size_t i = 0; i < 6; ++i) {
    velocity[i] = (after[i] - before[i]) / (2 * kFrameDifference);
    acceleration[i] = (after[i] - 2 * at[i] + before[i]) / (kFrameDifference * kFrameDifference);
  }
  plan.plan_leg(at, velocity, acceleration);
}

bool TrackFrame::terminal_condition() { return plan_->over(); }

void TrackFrame::next_state() {
  Plan& plan = *plan_;
  const RobotState& state = robot_->state();
  const double period = robot_->task().servo_period(), duration = robot_->step_duration();
  RobotCommand& command = robot_->command();
  Tick begin = state.desired_tick;
  if (plan.first && state.at_rest()) {
    begin = std::max(begin, robot_->task().tick() + MacrostepTiming::kFirstMargin);
    command.start_tick = begin;  // the frame moves: the start tick must be known
  }
  const auto seconds = [period](Tick from, Tick to) {
    return (static_cast<double>(to) - static_cast<double>(from)) * period;
  };

  const std::optional<MovingFrame> measured = plan.frame();
  if (measured) {
    plan.lost = 0;
    plan.observer.correct(measured->after(seconds(measured->tick, begin)), duration);
  } else {
    if (++plan.lost > plan.patience) {
      throw NonFatalError(ErrorCode::sensor_not_ready,
                          "no reading of the moving frame for " + std::to_string(plan.patience) + " steps",
                          {robot_->task().process_name(), robot_->name(), 0, state.tick});
    }
    plan.observer.coast(duration);
  }
  Eigen::Vector3d rate_at_end = Eigen::Vector3d::Zero();  // of the correction
  if (measured && !plan.first) {
    const MovingFrame now = measured->after(seconds(measured->tick, state.tick));
    const Pose reference = now.pose * plan.relative(plan.time - seconds(state.tick, begin));
    plan.error = now.pose.linear().transpose() * (reference.translation() - state.pose.translation());
    const Eigen::Vector3d wanted = clamped(plan.correction + plan.error, kMostCorrection) - plan.correction;
    rate_at_end = (kCorrection * wanted - plan.correction_speed) / std::max(kCorrectionDelay, duration);
  }

  plan.correction_jerk = (rate_at_end - plan.correction_rate) / duration;

  const double h = kFrameDifference;
  const Pose before = plan.tool(duration - h), there = plan.tool(duration), after = plan.tool(duration + h);
  Twist twist, rate;
  const Eigen::Vector3d turn_before = rotation_vector(there.linear() * before.linear().transpose()) / h;
  const Eigen::Vector3d turn_after = rotation_vector(after.linear() * there.linear().transpose()) / h;
  twist << (after.translation() - before.translation()) / (2 * h), 0.5 * (turn_before + turn_after);
  rate << (after.translation() - 2 * there.translation() + before.translation()) / (h * h),
      (turn_after - turn_before) / h;
  command_motion(command, {there, twist, rate});

  plan.first = false;
  plan.observer.advance(duration);
  plan.correction = plan.correction_at(duration);
  plan.correction_speed += (0.5 * duration) * (plan.correction_rate + rate_at_end);
  plan.correction_rate = rate_at_end;
  plan.time += duration;
  if (!plan.arrived()) return;
  if (plan.stayed == 0 && !(plan.error.norm() <= plan.limits.tolerance)) return;
  plan.stayed += duration;
  if (plan.stayed >= plan.path[std::min(plan.point, plan.path.size() - 1)].dwell && ++plan.point < plan.path.size()) {
    // from the end of the last leg, at rest
    const Pose x = plan.path[plan.point - 1].pose;
    plan.plan_leg(plan.coordinates(x), Coordinates{}, Coordinates{});
  }
}

}  // namespace mrroc
