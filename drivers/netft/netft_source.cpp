#include "drivers/netft/netft_source.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string>

#include "clock/wall/wait.hpp"
#include "config/text/message_text.hpp"
#include "drivers/netft/http_get.hpp"
#include "drivers/netft/lockstep_netft.hpp"
#include "mrroc/errors.hpp"
#include "vsp/parameters.hpp"

namespace mrroc::netft {

namespace {

using config::in_quotes;
using config::number_text;

/// A deployment's keys below [sensors.NAME.netft].
class Keys {
 public:
  Keys(const config::SensorEntry& entry, const config::KeyValues& values) : entry_(entry), values_(values) {}

  double number(const std::string& key) const {
    const auto found = values_.numbers.find(key);
    if (found == values_.numbers.end() || found->second.size() != 1) refuse(key, "missing", "a number");
    return found->second[0];
  }
  std::uint16_t port(const std::string& key) const {
    const double value = number(key);
    if (!(value >= 1 && value <= 65535) || value != std::floor(value)) {
      refuse(key, number_text(value), "a whole number from 1 to 65535");
    }
    return static_cast<std::uint16_t>(value);
  }
  const std::string& text(const std::string& key) const {
    const auto found = values_.texts.find(key);
    if (found == values_.texts.end()) refuse(key, "missing", "a text");
    return found->second;
  }
  [[noreturn]] void refuse(const std::string& key, const std::string& problem, const std::string& expected) const {
    vsp::refuse(entry_, "netft." + key, problem, expected);
  }

 private:
  const config::SensorEntry& entry_;
  const config::KeyValues& values_;
};

std::optional<Calibration> calibration_of(const Keys& keys) {
  const double force = keys.number("counts_per_force"), torque = keys.number("counts_per_torque");
  if (force == 0 && torque == 0) return {};
  if (!(force > 0)) keys.refuse("counts_per_force", number_text(force), "a number above 0 beside counts_per_torque");
  if (!(torque > 0)) keys.refuse("counts_per_torque", number_text(torque), "a number above 0 beside counts_per_force");
  const auto newton = newtons(keys.text("force_unit"));
  if (!newton) keys.refuse("force_unit", in_quotes(keys.text("force_unit")), "N, kN, lbf, klbf, kgf or gf");
  const auto newton_metre = newton_metres(keys.text("torque_unit"));
  if (!newton_metre) {
    keys.refuse("torque_unit", in_quotes(keys.text("torque_unit")), "N-m, N-mm, kN-m, lbf-in, lbf-ft or kgf-cm");
  }
  return Calibration{*newton / force, *newton_metre / torque};
}

Requests requests_of(const Keys& keys) {
  const std::string& text = keys.text("requests");
  if (text == "automatic") return Requests::automatic;
  if (text == "stream") return Requests::stream;
  if (text == "polled") return Requests::polled;
  keys.refuse("requests", in_quotes(text), "'automatic', 'stream' or 'polled'");
}

constexpr std::int64_t kBetweenAttempts = clock::kSecond / 50;

/// The configuration page. A box that is still starting refuses the connection: tries again until `start_timeout`.
std::string get_page(const NetftOptions& options) {
  const std::int64_t end = clock::monotonic_ns() + to_ns(options.start_timeout);
  for (;;) {
    try {
      return http_get(options.address, options.http_port, kConfigurationPath, options.start_timeout);
    } catch (const HardwareError&) {
      if (clock::monotonic_ns() > end) throw;
    }
    clock::pause(kBetweenAttempts);
  }
}

/// Reads the sensor's own settings and checks them.
Calibration read_calibration(const NetftOptions& options, double servo_period) {
  if (options.calibration) return *options.calibration;
  const std::string page = get_page(options);
  const std::string address = "http://" + place_text(options.address, options.http_port) + kConfigurationPath;
  const SensorConfiguration read = read_configuration(page, address);
  if (!read.rdt_enabled) throw config::ConfigurationError(address, 0, "comrdte", "RDT is disabled", "'Enabled'");
  const double least = options.rate_min > 0 ? options.rate_min : 1 / servo_period;
  // rates are rounded: 333 Hz serves a period of 3 ms
  if (options.requests != Requests::polled && read.rate > 0 && read.rate < std::floor(least * (1 - 1e-6))) {
    throw config::ConfigurationError(address, 0, "comrdtrate", number_text(read.rate) + " Hz",
                                     "at least " + number_text(least) + " Hz, the servo rate or rate_min");
  }
  return read.calibration;
}

RdtOptions rdt_options(const NetftOptions& options, double servo_period) {
  return {options.address,
          options.port,
          options.timeout,
          options.start_timeout,
          options.requests == Requests::polled ? servo_period : 0,
          options.set_bias};
}

/// Reports at its end what has disturbed the records.
class ReportedNetft final : public vsp::Source {
 public:
  ReportedNetft(const NetftOptions& options, const vsp::SourceContext& context)
      : name_(context.entry.name), source_(options, *context.clock, context.servo_period) {}
  ~ReportedNetft() override {
    const std::string text = disturbances(source_.counters());
    if (!text.empty()) std::fprintf(stderr, "Net F/T of sensor %s: %s\n", name_.c_str(), text.c_str());
  }
  ReportedNetft(const ReportedNetft&) = delete;
  ReportedNetft& operator=(const ReportedNetft&) = delete;

  vsp::SourceState read(Tick wanted, vsp::RawReading& raw) noexcept override { return source_.read(wanted, raw); }
  std::string_view fault() const noexcept override { return source_.fault(); }

 private:
  std::string name_;
  NetftSource source_;
};

bool is_force_sensor(const vsp::SourceContext& context) {
  const auto& robots = context.deployment.robots;
  return std::any_of(robots.begin(), robots.end(),
                     [&](const auto& robot) { return robot.force_sensor == context.entry.name; });
}

void check(const vsp::SourceContext& context) {
  const config::SensorEntry& entry = context.entry;
  const std::string type = "'force_torque'";
  if (entry.type != "force_torque") vsp::refuse(entry, "source", "'netft' for the type " + in_quotes(entry.type), type);
  const auto calibration = entry.numbers.find("calibration");
  if (calibration != entry.numbers.end() &&
      std::any_of(calibration->second.begin(), calibration->second.end(), [](double each) { return each != 0; })) {
    vsp::refuse(entry, "calibration", "a matrix for gauge voltages beside the source 'netft'",
                "no such key: a Net F/T gives wrenches");
  }
  const bool stand_in = entry.driver && entry.driver->simulated;
  if (context.clock == nullptr || (context.clock->simulated() && !stand_in)) {
    vsp::refuse(entry, "source", "'netft' with simulated time", "clock = \"real\" in [deployment]");
  }
}

}  // namespace

NetftOptions netft_options(const config::SensorEntry& entry, const config::KeyValues& values) {
  const Keys keys(entry, values);
  NetftOptions options;
  options.address = keys.text("address");
  options.port = keys.port("port");
  options.http_port = keys.port("http_port");
  options.calibration = calibration_of(keys);
  options.timeout = keys.number("timeout");
  options.start_timeout = keys.number("start_timeout");
  options.rate_min = keys.number("rate_min");
  options.requests = requests_of(keys);
  const std::string& bias = keys.text("sensor_bias");
  if (bias != "keep" && bias != "set") keys.refuse("sensor_bias", in_quotes(bias), "'keep' or 'set'");
  options.set_bias = bias == "set";
  return options;
}

NetftFault fault_of(const Record& record) noexcept {
  std::array<char, 201> text{};
  std::snprintf(text.data(), text.size(), "the Net F/T reports status %s", status_text(record.status).c_str());
  NetftFault fault;
  fault.assign(text.data());
  return fault;
}

void fill(const Calibration& calibration, const Record& record, vsp::RawReading& raw) noexcept {
  raw.count = 6;
  for (std::size_t i = 0; i < 6; ++i) {
    const double factor = i < 3 ? calibration.newtons_per_count : calibration.newton_metres_per_count;
    raw.values[i] = -factor * record.counts[i];
  }
}

NetftSource::NetftSource(const NetftOptions& options, const clock::Clock& clock, double servo_period)
    : clock_(&clock),
      period_ns_(to_ns(servo_period)),
      silent_after_(static_cast<Tick>(std::ceil(options.timeout / servo_period))),
      biased_(options.set_bias),
      calibration_(read_calibration(options, servo_period)),
      client_(rdt_options(options, servo_period)) {}

Tick NetftSource::tick_of(std::int64_t arrival_ns) const noexcept {
  const std::int64_t since = arrival_ns - clock_->epoch_ns();
  return since <= 0 || clock_->epoch_ns() == 0 ? 0 : static_cast<Tick>(since / period_ns_);
}

vsp::SourceState NetftSource::read(Tick wanted, vsp::RawReading& raw) noexcept {
  const Measurement& newest = client_.newest();
  const Tick tick = tick_of(newest.arrival_ns);
  if (wanted > tick && wanted - tick > silent_after_) return vsp::SourceState::silent;
  if (!is_valid(newest.record.status)) {
    fault_ = fault_of(newest.record);
    return vsp::SourceState::faulty;
  }
  if (biased_ && newest.sensor_restarts > 0) {
    fault_.assign("the Net F/T has restarted and lost its zero, which sensor_bias = 'set' gave it at the start");
    return vsp::SourceState::faulty;
  }
  raw.tick = tick;
  fill(calibration_, newest.record, raw);
  return vsp::SourceState::ready;
}

std::unique_ptr<vsp::Source> open_netft(const NetftOptions& options, const vsp::SourceContext& context) {
  check(context);
  if (context.clock->simulated())
    return std::make_unique<LockstepNetft>(options, read_calibration(options, context.servo_period),
                                           context.servo_period);
  NetftOptions chosen = options;
  if (chosen.requests == Requests::automatic) {
    chosen.requests = is_force_sensor(context) ? Requests::polled : Requests::stream;
  }
  return std::make_unique<ReportedNetft>(chosen, context);
}

}  // namespace mrroc::netft
