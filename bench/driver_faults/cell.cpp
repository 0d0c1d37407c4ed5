#include "driver_faults/cell.hpp"

#include <algorithm>
#include <cmath>

#include "clock/wall/monotonic.hpp"

namespace mrroc::driver_faults {

namespace {

constexpr double kPeriod = ur::kPeriod;
constexpr double kStill = 1e-3;  // rad/s
constexpr int kMost = 5000;      // ticks

sim::NetftSettings free_ports() {
  sim::NetftSettings settings;
  settings.port = settings.http_port = 0;
  return settings;
}

double fastest(const sim::ur::Six& velocity) {
  double most = 0;
  for (const double each : velocity) most = std::max(most, std::abs(each));
  return most;
}

}  // namespace

/// The Net F/T at the arm's flange, without a tool.
class Cell::Wrist final : public edp::ForceSensor {
 public:
  Wrist(const netft::NetftOptions& options, const clock::Clock& clock) : source_(options, clock, kPeriod) {}

  const Pose& mount() const noexcept override { return mount_; }
  edp::WrenchReading read(Tick tick, const Pose*) noexcept override {
    const vsp::SourceState state = source_.read(tick, raw_);
    if (state != vsp::SourceState::ready) return {ErrorCode::sensor_hardware, Wrench::Zero()};
    return {ErrorCode::none, -Eigen::Map<const Wrench>(raw_.values.data())};
  }
  void bias() noexcept override {}

 private:
  netft::NetftSource source_;
  vsp::RawReading raw_;
  Pose mount_ = Pose::Identity();
};

Cell::Cell()
    : sensor(free_ports(), [](double) { return Wrench::Zero(); }),
      model_(ur::Interface::position),
      models_((model_.change().home << 0, -1.5, 1.5, -1.5, -1.5, 0, model_)) {
  ur::UrOptions options = controller.driver_options();
  options.missed_max = 25;
  options.watchdog = 0.1;
  hardware_ = std::make_unique<ur::UrHardware>(options, model_, kPeriod);
  hardware_->open();
  clock_.epoch = clock::monotonic_ns();
  netft::NetftOptions of_sensor;
  of_sensor.address = "127.0.0.1";
  of_sensor.port = sensor.port();
  of_sensor.http_port = sensor.http_port();
  wrist_ = std::make_unique<Wrist>(of_sensor, clock_);
  ticker_.emplace(*hardware_->clock(), clock_.epoch_ns(), kPeriod);
  servo_ = std::make_unique<edp::Servo>(models_, *hardware_, kPeriod, channel_);
  servo_->use_force_sensor(*wrist_, Wrench::Constant(100));
  effector_ = std::make_unique<edp::Effector>(models_, kPeriod, channel_);
  effector_->use_force_sensor(wrist_->mount());
}

Cell::~Cell() = default;

void Cell::tick() {
  const auto [tick, ahead, measured] = ticker_->wait_next();
  const double place = static_cast<double>(tick) + ahead;
  servo_->tick(tick, ahead, measured);
  edp::Reply reply;
  while (effector_->poll(reply)) reply_ = reply;
  now_ = tick;
  judge(place - then_);
  then_ = place;
}

/// Set-points while the drives are on; the arm always.
void Cell::judge(double elapsed) {
  const AxisParameters& axis = model_.parameters().axes.front();
  const double speed = fastest(controller.ask([](sim::ur::VirtualController& c) { return c.velocity(); }));
  worst.speed = std::max(worst.speed, speed / axis.velocity_max);
  if (speed > kStill) moved_ = now_;
  const edp::Snapshot& seen = servo_->snapshot();
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
  if (effector_->accept(command, ++number_, refused)) reply_ = refused;
}

void Cell::start_move(double way) {
  RobotCommand command;
  command.kind = CommandKind::joint;
  command.relative = true;
  command.joints = JointVector::Constant(6, way);
  command.motion_steps = command.reply_step = 400;
  send(command);
}

bool Cell::recover() {
  for (int i = 0; i < kMost;) {
    RobotCommand command;
    command.kind = CommandKind::recover;
    send(command);
    for (; i < kMost && !answered(); ++i) tick();
    if (servo_->snapshot().enabled()) return true;
    for (int pause = 0; pause < 100; ++pause, ++i) tick();
  }
  return false;
}

}  // namespace mrroc::driver_faults
