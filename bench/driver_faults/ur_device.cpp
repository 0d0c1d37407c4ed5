#include "driver_faults/ur_device.hpp"

#include <algorithm>
#include <cmath>

#include "clock/wall/monotonic.hpp"

namespace mrroc::driver_faults {

namespace {

sim::NetftSettings free_ports() {
  sim::NetftSettings settings;
  settings.port = settings.http_port = 0;
  return settings;
}

}  // namespace

/// The Net F/T at the arm's flange, without a tool.
class UrDevice::Wrist final : public edp::ForceSensor {
 public:
  Wrist(const netft::NetftOptions& options, const clock::Clock& clock) : source_(options, clock, kPeriod) {}

  const Pose& mount() const noexcept override { return mount_; }
  edp::WrenchReading read(Tick tick, const Pose*) noexcept override {
    const vsp::SourceState state = source_.read(tick, raw_);
    if (state != vsp::SourceState::ready) return {ErrorCode::sensor_hardware, Wrench::Zero()};
    return {ErrorCode::none, -Eigen::Map<const Wrench>(raw_.values.data())};
  }
  void bias() noexcept override {}
  void carry(const Load&) noexcept override {}

 private:
  netft::NetftSource source_;
  vsp::RawReading raw_;
  Pose mount_ = Pose::Identity();
};

UrDevice::UrDevice() : sensor(free_ports(), [](double) { return Wrench::Zero(); }), model_(ur::Interface::position) {
  model_.change().home << 0, -1.5, 1.5, -1.5, -1.5, 0;
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
}

UrDevice::~UrDevice() = default;

edp::ForceSensor* UrDevice::wrist() { return wrist_.get(); }

/// As the controller has it.
double UrDevice::speed(const edp::Snapshot&) {
  double most = 0;
  for (const double each : controller.ask([](sim::ur::VirtualController& c) { return c.velocity(); }))
    most = std::max(most, std::abs(each));
  return most;
}

}  // namespace mrroc::driver_faults
