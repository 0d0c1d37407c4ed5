#include "drivers/ur/wrench/wrench_source.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "drivers/ur/lockstep.hpp"
#include "geometry/rigid_motion.hpp"
#include "mrroc/errors.hpp"
#include "vsp/parameters.hpp"

namespace mrroc::ur {
namespace {

/// Address and port are those of the robot whose controller measures.
WrenchOptions options_of(const vsp::SourceContext& context) {
  const config::KeyValues& keys = *context.entry.driver;
  const config::KeyValues& robot = context.deployment.robot(context.entry.robot).driver;
  return {robot.text("address"),        static_cast<int>(std::lround(robot.number("rtde_port"))),
          keys.number("frequency"),     keys.number("timeout"),
          keys.number("start_timeout"), context.clock->simulated()};
}

void check(const vsp::SourceContext& context) {
  const config::SensorEntry& entry = context.entry;
  const auto calibration = entry.numbers.find("calibration");
  if (calibration != entry.numbers.end() &&
      std::any_of(calibration->second.begin(), calibration->second.end(), [](double each) { return each != 0; }))
    vsp::refuse(entry, "calibration", "a matrix for gauge voltages beside the source 'ur'",
                "no such key: the controller gives wrenches");
  if (vsp::number(entry, "tool_mass") > 0)
    vsp::refuse(entry, "tool_mass", "a weight that the controller has already taken out of its wrench",
                "no such key beside the source 'ur': the robot's load is the controller's payload");
}

/// Reports at its end what has disturbed the packages.
class ReportedWrench final : public vsp::Source {
 public:
  explicit ReportedWrench(const vsp::SourceContext& context)
      : name_(context.entry.name),
        source_(options_of(context),
                pose_from_rpy(vsp::vector3(context.entry, "position"), vsp::vector3(context.entry, "rotation")),
                *context.clock, context.servo_period) {}
  ~ReportedWrench() override {
    const std::string text = disturbances(source_.counters());
    if (!text.empty()) std::fprintf(stderr, "UR controller of sensor %s: %s\n", name_.c_str(), text.c_str());
  }
  ReportedWrench(const ReportedWrench&) = delete;
  ReportedWrench& operator=(const ReportedWrench&) = delete;

  vsp::SourceState read(Tick wanted, vsp::RawReading& raw) noexcept override { return source_.read(wanted, raw); }

 private:
  std::string name_;
  UrWrenchSource source_;
};

}  // namespace

UrWrenchSource::UrWrenchSource(const WrenchOptions& options, const Pose& mount, const clock::Clock& clock,
                               double servo_period)
    : clock_(&clock),
      mount_(mount),
      period_ns_(std::llround(servo_period * 1e9)),
      silent_after_(static_cast<Tick>(std::ceil(options.timeout / servo_period))),
      period_(servo_period),
      lockstep_(options.lockstep),
      client_(options) {}

Tick UrWrenchSource::tick_of(std::int64_t arrival_ns) const noexcept {
  const std::int64_t since = arrival_ns - clock_->epoch_ns();
  return since <= 0 || clock_->epoch_ns() == 0 ? 0 : static_cast<Tick>(since / period_ns_);
}

vsp::SourceState UrWrenchSource::read(Tick wanted, vsp::RawReading& raw) noexcept {
  if (lockstep_) return await(wanted, raw);
  const MeasuredWrench& newest = client_.newest();
  const Tick tick = tick_of(newest.arrival_ns);
  if (wanted > tick && wanted - tick > silent_after_) return vsp::SourceState::silent;
  raw.tick = tick;
  fill(newest, raw);
  return vsp::SourceState::ready;
}

vsp::SourceState UrWrenchSource::await(Tick wanted, vsp::RawReading& raw) noexcept {
  const MeasuredWrench* const newest = lost_ ? nullptr : client_.await(wanted, period_);
  lost_ = newest == nullptr;
  if (lost_) return vsp::SourceState::silent;
  raw.tick = tick_of_package(newest->package.timestamp, period_);
  fill(*newest, raw);
  return vsp::SourceState::ready;
}

void UrWrenchSource::fill(const MeasuredWrench& newest, vsp::RawReading& raw) const noexcept {
  raw.count = 6;
  Eigen::Map<Wrench>(raw.values.data()) = -load_on_sensor(newest.package, newest.point, mount_);
}

std::unique_ptr<vsp::Source> open_ur_wrench(const vsp::SourceContext& context) {
  check(context);
  try {
    return std::make_unique<ReportedWrench>(context);
  } catch (const ConnectionError& error) {
    throw HardwareError(ErrorCode::sensor_hardware, error.what());
  }
}

}  // namespace mrroc::ur
