#pragma once

#include <chrono>
#include <string>
#include <thread>

#include "clock/wall/monotonic.hpp"
#include "drivers/netft/netft_source.hpp"
#include "links/test_clock.hpp"
#include "sim/netft/netft_server.hpp"

namespace mrroc::netft {

inline constexpr double kServoPeriod = 0.002;

/// Checks `condition` every millisecond until it holds; false when it does not hold within half a minute.
template <class Condition>
bool eventually(Condition condition) {
  for (int i = 0; i < 30'000; ++i) {
    if (condition()) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return condition();
}

inline sim::NetftSettings free_ports() {
  sim::NetftSettings settings;
  settings.port = settings.http_port = 0;
  return settings;
}

inline Wrench any_load() { return Wrench{{12.5, -3.25, 40, 0.5, -1.5, 2}}; }

/// A simulated sensor on loopback and the time of its clients.
class Rig {
 public:
  explicit Rig(const sim::NetftSettings& settings = free_ports())
      : server_(settings, [](double) { return any_load(); }) {
    clock_.epoch = clock::monotonic_ns();
  }

  sim::NetftServer& server() { return server_; }
  const sim::NetftServer& server() const { return server_; }
  const clock::Clock& clock() const { return clock_; }
  Tick now() const { return static_cast<Tick>((clock::monotonic_ns() - clock_.epoch_ns()) / 2'000'000); }

  /// Of this sensor. A long start, a short silence.
  NetftOptions options() const {
    NetftOptions options;
    options.address = "127.0.0.1";
    options.port = server_.port();
    options.http_port = server_.http_port();
    options.start_timeout = 30;
    return options;
  }
  void hold(const Wrench& load) {
    server_.set_load([load](double) { return load; });
  }

 private:
  sim::NetftServer server_;
  links::TestClock clock_;
};

/// A client of the rig's sensor, as a VSP reads it.
class Reader {
 public:
  Reader(Rig& rig, const NetftOptions& options) : rig_(&rig), source_(options, rig.clock(), kServoPeriod) {}
  explicit Reader(Rig& rig) : Reader(rig, rig.options()) {}

  vsp::SourceState read() { return source_.read(rig_->now(), raw_); }
  bool reaches(vsp::SourceState state) {
    return eventually([&] { return read() == state; });
  }
  /// Whether the support forces become `load`'s, within the resolution of the counts.
  bool measures(const Wrench& load) {
    return eventually([&] {
      return read() == vsp::SourceState::ready && raw_.count == 6 &&
             (Eigen::Map<const Wrench>(raw_.values.data()) + load).cwiseAbs().maxCoeff() < 2e-6;
    });
  }
  const vsp::RawReading& raw() const { return raw_; }
  NetftSource& source() { return source_; }
  std::string fault() const { return std::string(source_.fault()); }
  RdtCounters counters() const { return source_.counters(); }

 private:
  Rig* rig_;
  NetftSource source_;
  vsp::RawReading raw_;
};

}  // namespace mrroc::netft
