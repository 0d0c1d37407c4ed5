#include "driver_faults/cell.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace mrroc::driver_faults {

namespace {

constexpr double kStill = 1e-3;  // rad/s
constexpr int kMost = 5000;      // ticks

}  // namespace

Cell::Cell(std::unique_ptr<Device> device)
    : device_(std::move(device)),
      models_(device_->model()),
      servo_(models_, device_->hardware(), kPeriod, channel_),
      effector_(models_, kPeriod, channel_) {
  edp::ForceSensor* const wrist = device_->wrist();
  if (wrist == nullptr) return;
  servo_.use_force_sensor(*wrist, Wrench::Constant(100));
  effector_.use_force_sensor(wrist->mount());
}

void Cell::tick() {
  const auto [tick, ahead, measured] = device_->wait_next();
  const double place = static_cast<double>(tick) + ahead;
  servo_.tick(tick, ahead, measured);
  edp::Reply reply;
  while (effector_.poll(reply)) reply_ = reply;
  now_ = tick;
  judge(place - then_);
  then_ = place;
}

/// Set-points while the drives are on; the arm always.
void Cell::judge(double elapsed) {
  const AxisParameters& axis = device_->model().parameters().axes.front();
  const double speed = device_->speed(servo_.snapshot());
  worst.speed = std::max(worst.speed, speed / axis.velocity_max);
  if (speed > kStill) moved_ = now_;
  const edp::Snapshot& seen = servo_.snapshot();
  const JointVector position = seen.desired.position;
  continuous_ = edp::has_power(seen.state) ? continuous_ + 1 : 0;
  JointVector velocity = JointVector::Zero(position.size());
  if (continuous_ > 1) velocity = (position - position_) / (elapsed * kPeriod);
  if (continuous_ > 2) {
    worst.set_speed = std::max(worst.set_speed, velocity.cwiseAbs().maxCoeff() / axis.velocity_max);
    // mean velocities are those of the middles of their intervals
    const double between = (elapsed + elapsed_) / 2 * kPeriod;
    const double change = (velocity - velocity_).cwiseAbs().maxCoeff() / between;
    worst.set_acceleration = std::max(worst.set_acceleration, change / axis.acceleration_max);
  }
  position_ = position;
  velocity_ = velocity;
  elapsed_ = elapsed;
}

void Cell::ticks(int count) {
  for (int i = 0; i < count; ++i) tick();
}

bool Cell::settle() {
  for (int i = 0; i < kMost; ++i) {
    tick();
    if (now_ > moved_ + 50 && (answered() || fault() != ErrorCode::none)) return true;
  }
  return false;
}

void Cell::send(const RobotCommand& command) {
  edp::Reply refused;
  if (effector_.accept(command, ++number_, refused)) reply_ = refused;
}

void Cell::start_move(double way) {
  RobotCommand command;
  command.kind = CommandKind::joint;
  command.relative = true;
  command.joints = JointVector::Constant(device_->model().joint_count(), way);
  command.motion_steps = command.reply_step = 400;
  send(command);
}

bool Cell::recover() {
  for (int i = 0; i < kMost;) {
    RobotCommand command;
    command.kind = CommandKind::recover;
    send(command);
    for (; i < kMost && !answered(); ++i) tick();
    if (servo_.snapshot().enabled()) return true;
    for (int pause = 0; pause < 100; ++pause, ++i) tick();
  }
  return false;
}

}  // namespace mrroc::driver_faults
