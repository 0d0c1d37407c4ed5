#include "testing/driver/bench.hpp"

#include <chrono>
#include <limits>
#include <thread>

#include "clock/wall/monotonic.hpp"
#include "config/entries/driver_entry.hpp"
#include "config/resources.hpp"
#include "edp/drivers/load_driver.hpp"

namespace mrroc::driver_test {

namespace {

constexpr int kMotionTicks = 200;

/// The name of the driver's own table in a deployment.
std::string table_of(const std::string& driver) {
  const auto file = config::Table::load(config::type_file("drivers", driver, driver + ".toml"));
  return file.optional_text("table").value_or(driver);
}

}  // namespace

void expect(bool holds, const std::string& otherwise) {
  if (!holds) throw Failure(otherwise);
}

Bench::~Bench() {
  close();
  device().stop();
}

JointVector Bench::home() const {
  JointVector shafts;
  if (model().joints_to_motors(model().parameters().home, shafts) != ErrorCode::none)
    throw std::runtime_error("robot " + subject_.type + ": home is out of reach");
  return shafts;
}

config::Deployment Bench::deployment(const std::string& more) {
  std::string text = "[deployment]\nname = \"driver_test\"\nclock = \"real\"\n";
  text.append("servo_period = ").append(std::to_string(period())).append("\n[mp]\nprogram = \"/bin/true\"\n");
  text.append("[robots.robot]\n");
  text.append("type = \"").append(subject_.type).append("\"\nprogram = \"/bin/true\"\n");
  if (!subject_.parameters.empty()) text.append("parameters = \"").append(subject_.parameters.string()).append("\"\n");
  text.append("hardware = \"").append(subject_.driver).append("\"\n[robots.robot.");
  text.append(table_of(subject_.driver)).append("]\n").append(device().keys()).append("\n").append(more).append("\n");
  if (device().world() != nullptr) text.append("[sim]\nscene = \"scene.xml\"\n");
  const auto file = scratch_.write("deployment.toml", text);
  scratch_.write("scene.xml", "<mujoco/>");
  return config::load_deployment(file);
}

void Bench::need(Trouble trouble) const {
  if (!subject_.stand_in.has(trouble)) throw NotMade("its stand-in cannot make this trouble");
}

void Bench::make() {
  deployment_ = deployment();
  hardware_ =
      edp::load_driver({deployment_.robots.front(), model(), period(), device().simulated_time(), device().world(), 0});
}

void Bench::open() {
  device().start(home());
  make();
  target = home();
  connect();
}

void Bench::connect() {
  hardware_->open();
  if (edp::RobotClock* const clock = hardware_->clock(); clock != nullptr && !device().simulated_time())
    ticker_.emplace(*clock, clock::monotonic_ns(), period());
}

void Bench::close() {
  ticker_.reset();
  hardware_.reset();
}

edp::RobotTicker::Place Bench::next() {
  const edp::RobotTicker::Place place =
      ticker_ ? ticker_->wait_next() : edp::RobotTicker::Place{now_, 0, static_cast<double>(now_)};
  now_ = place.tick + 1;
  device().advance(place.tick);
  return place;
}

void Bench::pace() const {
  if (!ticker_ && !subject_.stand_in.simulated_time())
    std::this_thread::sleep_for(std::chrono::duration<double>(period()));
}

const edp::HardwareInput& Bench::tick() {
  exchange(next());
  pace();
  return input_;
}

bool Bench::beat(edp::Beat& beat) {
  edp::RobotClock& clock = *hardware_->clock();
  if (!clock.wait(clock::monotonic_ns() + std::llround(100e9 * clock.period()), beat)) return false;
  exchange({now_, 0, static_cast<double>(now_)});
  ++now_;
  return true;
}

void Bench::exchange(edp::RobotTicker::Place place) {
  input_ = {};
  input_.motors = JointVector::Constant(axes(), std::numeric_limits<double>::quiet_NaN());
  input_.current = input_.motors;
  input_.time = place.measured;
  hardware_->read(place.tick, input_);
  device().read(input_.motors);
  hardware_->set_points(target, JointVector::Zero(axes()));
  hardware_->write(place.tick, JointVector::Zero(axes()));
  if (after_tick) after_tick();
}

const edp::HardwareInput& Bench::ticks(int count) {
  for (int i = 0; i < count; ++i) tick();
  return input_;
}

bool Bench::until(const std::function<bool(const edp::HardwareInput&)>& holds, int most) {
  for (int i = 0; i < most; ++i)
    if (holds(tick())) return true;
  return false;
}

void Bench::power() {
  models_.emplace(subject_.models);
  servo_ = std::make_unique<edp::Servo>(*models_, *hardware_, period(), channel_);
  effector_ = std::make_unique<edp::Effector>(*models_, period(), channel_);
  effector_->enable(true);
  expect(servo_until([](const edp::Snapshot& seen) { return seen.enabled(); }, 5000),
         "the servo could not switch the drives on: " + std::string(describe(seen().fault.code)));
}

void Bench::servo_ticks(int count) {
  for (int i = 0; i < count; ++i) count_servo_tick();
}

Counts Bench::count_servo_tick() {
  const auto [tick, ahead, measured] = next();
  const Counts before = counts();
  servo_->tick(tick, ahead, measured);
  const Counts done = counts() - before;
  device().read(seen().motors);
  edp::Reply reply;
  while (effector_->poll(reply)) reply_ = reply;
  if (after_tick) after_tick();
  pace();
  return done;
}

bool Bench::servo_until(const std::function<bool(const edp::Snapshot&)>& holds, int most) {
  for (int i = 0; i < most; ++i) {
    servo_ticks(1);
    if (holds(seen())) return true;
  }
  return false;
}

JointVector Bench::way(double part) const {
  JointVector way(axes());
  for (Eigen::Index i = 0; i < axes(); ++i) {
    const AxisParameters& axis = model().parameters().axes[static_cast<std::size_t>(i)];
    const double seconds = kMotionTicks * period();
    // a quintic over `seconds` needs 5.8 way / seconds^2 of acceleration, 60 way / seconds^3 of jerk
    const double most = std::min({0.2 * axis.velocity_max * seconds, axis.acceleration_max * seconds * seconds / 40,
                                  axis.jerk_max * seconds * seconds * seconds / 400});
    const double above = axis.position_max - model().parameters().home[i];
    const double below = model().parameters().home[i] - axis.position_min;
    way[i] = part * (above > below ? std::min(most, above / 2) : -std::min(most, below / 2));
  }
  return way;
}

void Bench::start_move(double part) {
  RobotCommand command;
  command.kind = CommandKind::joint;
  command.relative = true;
  command.joints = way(part);
  command.motion_steps = command.reply_step = kMotionTicks;
  reply_ = {};
  edp::Reply refused;
  if (effector_->accept(command, ++number_, refused)) reply_ = refused;
}

std::string Bench::reason() const {
  if (seen().fault.code != ErrorCode::none)
    return std::string(describe(seen().fault.code)).append(" ").append(describe(seen().fault.detail).view());
  if (reply_.command != number_) return "no answer";
  return std::string(describe(reply_.state.error.code)).append(" ").append(reply_.state.error.detail.view());
}

bool Bench::answered(std::uint64_t number) {
  return reply_.command == number && reply_.state.error.error_class == ErrorClass::none;
}

bool Bench::move(double part) {
  start_move(part);
  servo_ticks(kMotionTicks + 50);
  return answered(number_);
}

bool Bench::recover() {
  RobotCommand command;
  command.kind = CommandKind::recover;
  reply_ = {};
  edp::Reply refused;
  if (effector_->accept(command, ++number_, refused)) return false;
  return servo_until([this](const edp::Snapshot&) { return reply_.command == number_; }, 5000) && answered(number_) &&
         seen().enabled();
}

}  // namespace mrroc::driver_test
