// A VSP without its transport: the first byte selects the sensor type, the second the monitored values. Then follow the
// sensor's keys in a deployment up to the line "====", then the events, tick by tick: raw readings of any bits,
// requests, configurations, states of its robot.
#include <stdlib.h>

#include <array>
#include <cmath>
#include <cstring>
#include <memory>

#include "config/entries/sensor_type.hpp"
#include "fuzz/fuzz.hpp"
#include "fuzz/memory_file.hpp"
#include "mrroc/errors.hpp"
#include "mrroc/sensors/ultrasonic.hpp"
#include "sensors/conveyor_encoder/conveyor_encoder_sensor.hpp"
#include "sensors/digital_input/digital_input_sensor.hpp"
#include "sensors/force_torque/force_torque_sensor.hpp"
#include "sensors/infrared/infrared_sensor.hpp"
#include "sensors/operator_input/operator_input_sensor.hpp"
#include "sensors/time/time_sensor.hpp"
#include "sensors/tracker/tracker_sensor.hpp"
#include "sensors/ultrasonic/ultrasonic_sensor.hpp"
#include "vsp/sampler.hpp"

namespace {

using namespace mrroc;
using namespace mrroc::vsp;

constexpr double kServoPeriod = 0.002;

template <class Sensor>
std::unique_ptr<VirtualSensor> made() {
  return std::make_unique<Sensor>();
}

struct Kind {
  const char* type;
  std::unique_ptr<VirtualSensor> (*make)();
};

constexpr std::array<Kind, 8> kKinds{{{"conveyor_encoder", &made<ConveyorEncoderSensor>},
                                      {"digital_input", &made<DigitalInputSensor>},
                                      {"force_torque", &made<ForceTorqueSensor>},
                                      {"infrared", &made<InfraredSensor>},
                                      {"operator_input", &made<OperatorInputSensor>},
                                      {"time", &made<TimeSensor>},
                                      {"tracker", &made<TrackerSensor>},
                                      {"ultrasonic", &made<UltrasonicSensor>}}};

/// A source with the readings of the input.
class AnySource final : public Source {
 public:
  SourceState read(Tick wanted, RawReading& raw) noexcept override {
    raw = next;
    raw.tick = std::min(next.tick, wanted);
    return state;
  }
  RawReading next;
  SourceState state = SourceState::not_ready;
};

class CheckingSink final : public ReadingSink {
 public:
  explicit CheckingSink(std::size_t channels) : channels_(channels) {}
  void reply(const Caller&, const SensorReading& reading) override { check(reading); }
  void publish(const SensorReading& reading) override { check(reading); }

 private:
  void check(const SensorReading& reading) const {
    if (reading.error.error_class != ErrorClass::none) return;
    if (reading.sequence == 0) return;  // the answer to a configuration
    fuzz::require(reading.channel_count == channels_, "a reading without an error is complete");
    for (std::size_t i = 0; i < channels_; ++i)
      fuzz::require(std::isfinite(reading.values[i]), "a reading without an error is finite");
  }
  std::size_t channels_;
};

RobotState any_state(fuzz::Bytes& input, Tick now) {
  RobotState state;
  state.tick = now;
  state.synchronised = (input.take<std::uint8_t>() & 1) != 0;
  for (int i = 0; i < 12; ++i) state.pose.affine()(i / 4, i % 4) = input.take<double>();
  return state;
}

/// A message of one of the types, or of none, with any content.
Message any_configuration(fuzz::Bytes& input) {
  constexpr std::array<Message (*)(), 6> kTypes{
      [] { return pack(Carrying{}); },   [] { return pack(LowPassAt{}); },       [] { return pack(InfraredRange{}); },
      [] { return pack(PresenceAt{}); }, [] { return pack(UltrasonicRange{}); }, [] { return Message{}; }};
  Message message = kTypes[input.take<std::uint8_t>() % kTypes.size()]();
  for (std::size_t i = 0; i + sizeof(double) <= message.size; i += sizeof(double)) {
    const auto value = input.take<double>();
    std::memcpy(message.content.data() + i, &value, sizeof value);
  }
  return message;
}

void run(VirtualSensor& sensor, const config::SensorEntry& entry, const RawWatch& watch, fuzz::Bytes& input) {
  AnySource source;
  const bool published = (input.take<std::uint8_t>() & 1) != 0;
  Sampler sampler(sensor, source, published ? 3 : 0, entry.wants_effector_state);
  sampler.watch(watch);
  CheckingSink sink(sensor.channels().size());
  Tick now = 0;
  while (!input.empty()) {
    now += input.take<std::uint8_t>() % 4;
    const auto event = input.take<std::uint8_t>();
    source.state = static_cast<SourceState>(event % 3);
    if ((event & 4) != 0) sampler.on_request({}, {SensorRequestKind::reading, now}, now, sink);
    if ((event & 8) != 0) sampler.on_request({}, {SensorRequestKind::bias, 0}, now, sink);
    if ((event & 64) != 0)
      sampler.on_request({}, {SensorRequestKind::configure, 0, any_configuration(input)}, now, sink);
    if ((event & 16) != 0) sampler.on_effector_state(any_state(input, now));
    if ((event & 32) != 0) {
      source.next.tick = now;
      source.next.count = static_cast<std::uint32_t>(sensor.raw_channels().size());
      for (std::size_t i = 0; i < source.next.count; ++i) source.next.values[i] = input.take<double>();
    }
    sampler.on_tick(now, sink);
  }
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const bool share = setenv("MRROC_SHARE", MRROC_BINARY_DIR "/share/mrroc", 1) == 0;
  static const fuzz::MemoryFile keys;
  fuzz::require(share, "the environment can be set");
  fuzz::Bytes input(data, size);
  const Kind& kind = kKinds[input.take<std::uint8_t>() % kKinds.size()];
  config::SensorEntry entry;
  entry.name = "any";
  entry.type = kind.type;
  entry.robot = "arm";
  const auto watch = input.take<std::uint8_t>();
  if ((watch & 1) != 0) entry.frozen_after = watch * kServoPeriod;
  if ((watch & 2) != 0) entry.noise_max = {0.5, 0.5};
  const auto file = keys.write(input.take_section());
  if (fuzz::refuses<config::ConfigurationError>([&] { config::read_sensor_type(config::Table::load(file), entry); }))
    return 0;
  const auto sensor = kind.make();
  RawWatch watching;
  const bool wrong = fuzz::refuses<SystemError>([&] {
    sensor->set_up(entry, kServoPeriod);
    watching = RawWatch(entry, sensor->raw_channels(), kServoPeriod);
  });
  if (!wrong) run(*sensor, entry, watching, input);
  return 0;
}
