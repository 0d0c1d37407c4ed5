#pragma once

#include <limits>
#include <vector>

#include "vsp/sampler.hpp"

namespace mrroc::vsp {

/// A source of one value, the tick, unless a test sets another one.
class FakeSource : public Source {
 public:
  SourceState read(Tick wanted, RawReading& raw) noexcept override {
    ++reads;
    raw.tick = wanted;
    raw.count = count;
    raw.values[0] = bad ? bad_value : static_cast<double>(wanted);
    return state;
  }
  std::string_view fault() const noexcept override { return "the gauge is broken"; }
  SourceState state = SourceState::ready;
  std::uint32_t count = 1;
  bool bad = false;
  double bad_value = std::numeric_limits<double>::quiet_NaN();
  int reads = 0;
};

/// v = r - bias; records its calls.
class FakeSensor : public VirtualSensor {
 public:
  std::vector<Channel> channels() const override { return {{"out", "1"}}; }
  std::vector<Channel> raw_channels() const override { return {{"in", "1"}}; }
  void configure(const config::SensorEntry& /*entry*/, double /*servo_period*/) override {}
  bool continuous() const noexcept override { return is_continuous; }
  void track(const RawReading& r) noexcept override {
    if (tracked_count < tracked.size()) tracked[tracked_count++] = r.tick;
  }
  void aggregate(const RawReading& r, SensorReading& v) noexcept override {
    ++aggregations;
    v.values[0] = write ? r.values[0] - zero : std::numeric_limits<double>::infinity();
  }
  bool bias(const RawReading& r) noexcept override {
    if (can_bias) zero = r.values[0];
    return can_bias;
  }
  bool is_continuous = false;
  bool can_bias = true;
  bool write = true;
  double zero = 0;
  int aggregations = 0;
  std::vector<Tick> tracked = std::vector<Tick>(1000);
  std::size_t tracked_count = 0;
};

/// One output of a sampler.
struct Given {
  Tick at = 0;         ///< tick of the call
  bool reply = false;  ///< else a publication
  Caller caller;
  SensorReading reading;
};

class RecordingSink : public ReadingSink {
 public:
  void reply(const Caller& caller, const SensorReading& reading) override {
    given.push_back({now, true, caller, reading});
  }
  void publish(const SensorReading& reading) override { given.push_back({now, false, {}, reading}); }
  std::vector<Given> given;
  Tick now = 0;
};

}  // namespace mrroc::vsp
