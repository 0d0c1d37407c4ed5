#pragma once

#include <cstdint>
#include <vector>

#include "links/exchange/caller.hpp"
#include "mrroc/sensor_link.hpp"
#include "vsp/effector_states.hpp"
#include "vsp/raw_watch.hpp"
#include "vsp/source.hpp"
#include "vsp/virtual_sensor.hpp"

namespace mrroc::vsp {

using links::Caller;

/// The destination of readings: the shell's links. A sink forwards complete readings and never waits for a reader.
class ReadingSink {
 public:
  virtual ~ReadingSink() = default;
  /// The one answer to a request.
  virtual void reply(const Caller& caller, const SensorReading& reading) = 0;
  /// A non-interactive reading, for the buffer of every reader.
  virtual void publish(const SensorReading& reading) = 0;
};

/// The work of a VSP, without its transport. *Interactive*: a request is kept until its tick; then the hardware is
/// read, aggregated, and the reading returned to the caller. Every request is answered exactly once, in the order of
/// ticks, then of arrival. *Non-interactive*: a reading is published at every whole multiple of the publication period.
/// A reader keeps the last published reading in its own buffer, so only interactive callers wait for an aggregation.
///
/// All answers and the publication of one `on_tick` have the same reading (a bias makes a new one, and the readings
/// after a configuration are made with it). A reading without an error is complete and finite; a raw reading that is
/// incomplete or not finite, or a silent source, is HardwareError(sensor_hardware). A reading that has not come yet is
/// NonFatalError(sensor_not_ready); so is a missing e_l that the sensor needs.
///
/// The shell's loop, on the VSP's thread:
///
///     for (;;) {
///       clock.wait(sampler.next_wake());
///       for (every request that came) sampler.on_request(caller, request, clock.tick(), sink);
///       sampler.on_tick(clock.tick(), sink);
///     }
///
/// Allocates nothing after construction but for a configuration; throws only exceptions of the sink.
class Sampler {
 public:
  /// Requests that can wait at the same time; one more is answered at once with NonFatalError(busy).
  static constexpr std::size_t kMaxPending = 64;

  /// `publication_period` in ticks; 0: nothing is published. `follows_effector`: no reading is taken at a tick before
  /// the state e_l of that tick has come, or kStateLate has passed. `sensor` is configured; both outlive the sampler.
  /// Throws SystemError(configuration) when the sensor has no channels or more than a reading carries.
  Sampler(VirtualSensor& sensor, Source& source, Tick publication_period, bool follows_effector = false);

  /// Ticks for which a due reading waits for e_l, and by which e_l may be older than r (it is of r's own tick unless
  /// the robot's EDP has missed that one).
  static constexpr Tick kStateLate = 50;
  static constexpr Tick kStateAge = 5;

  /// Keeps a request until its tick; the next `on_tick` answers due requests.
  void on_request(const Caller& caller, const SensorRequest& request, Tick now, ReadingSink& sink);
  /// Also checks the hardware for frozen or noisy readings. Before the first tick.
  void watch(const RawWatch& watch) { watch_ = watch; }
  /// Takes e_l. Oldest first.
  void on_effector_state(const RobotState& state) noexcept { effector_.add(state); }
  /// Does the work due at `now`: answers requests, then publishes. May be called at any time, several times at a tick.
  void on_tick(Tick now, ReadingSink& sink);

  /// The tick at which `on_tick` has something to do; kNever: not before a request comes. Present or past: at once.
  Tick next_wake() const noexcept;
  /// Publications that were skipped because the VSP was not woken in time; the grid is never re-phased.
  std::uint64_t missed() const noexcept { return missed_; }

 private:
  struct Pending {
    Tick due = 0;
    Caller caller;
    SensorRequestKind kind = SensorRequestKind::reading;
    Message configuration;
  };

  bool answer_is_due(Tick now) const noexcept { return !pending_.empty() && pending_.front().due <= now; }
  bool raw_usable() const noexcept { return raw_fault_.error.error_class == ErrorClass::none; }
  bool waits_for_state(Tick now) noexcept;
  Tick next_due() const noexcept;
  void find_state() noexcept;
  void read_source(Tick now) noexcept;
  void check_raw(SourceState state, Tick now) noexcept;
  void answer_due(Tick now, ReadingSink& sink);
  SensorReading answer_to(const Message& configuration) noexcept;
  void aggregate() noexcept;
  void schedule_publication(Tick now) noexcept;

  VirtualSensor* sensor_;
  Source* source_;
  std::vector<Channel> channels_;
  std::vector<Channel> raw_channels_;
  std::vector<Pending> pending_;  ///< by due tick, then arrival
  Tick period_;
  Tick next_publication_ = 0;
  Tick next_track_ = 0;
  std::uint64_t missed_ = 0;
  RawReading raw_;
  SensorReading raw_fault_;  ///< in error when `raw_` is invalid
  SensorReading reading_;
  std::uint32_t configuration_ = 0;  ///< configurations taken
  bool fresh_ = false;               ///< `reading_` is of the `on_tick` under way
  RawWatch watch_;
  bool follows_;
  EffectorStates effector_;
  Tick patience_ = 0;  ///< due readings wait for e_l until this tick; 0: no wait
};

/// Ticks between two publications of `entry`: 0 when interactive, else 1 / (rate * servo_period). Throws
/// SystemError(configuration) unless that is a whole number of at least 1.
Tick publication_period(const config::SensorEntry& entry, double servo_period);

}  // namespace mrroc::vsp
