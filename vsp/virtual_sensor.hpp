#pragma once

#include <memory>
#include <string>
#include <vector>

#include "config/deployment.hpp"
#include "faults/fault_plan.hpp"
#include "mrroc/robot_state.hpp"
#include "mrroc/sensor_link.hpp"
#include "vsp/raw_reading.hpp"
#include "vsp/source.hpp"
#include "world/world_memory.hpp"

namespace mrroc::clock {
class Clock;
}
namespace mrroc::links {
class Domain;
}
namespace mrroc::process {
class PictureMemory;
}

namespace mrroc::vsp {

using config::Channel;

/// The objects from which a source can be opened. `world`: the simulated hardware, null without a simulated world;
/// `slot`: the sensor's index in the deployment. `servo_period` in s. `clock` and `domain`: for a source with its own
/// link; null in tests without a process. `pictures`: where a camera of hardware shows its pictures; null: nowhere.
struct SourceContext {
  const config::Deployment& deployment;
  const config::SensorEntry& entry;
  std::size_t slot;
  const world::WorldMemory* world;
  double servo_period;
  clock::Clock* clock = nullptr;
  links::Domain* domain = nullptr;
  std::vector<faults::FaultSwitch> faults = {};  ///< to be injected into the readings of its hardware
  process::PictureMemory* pictures = nullptr;
};

/// The aggregating function of one sensor type, the paper's equation (14): v = f_v(c_0, c_l, e_l, r).
///
///   r          `RawReading`, from a `Source`
///   e_l        state of the robot that the sensor is mounted on: `effector_state()`
///   c_0, c_l   settings of the control subsystems: `configure()` from the deployment, `bias()` and `reconfigure()` at
///              run time
///   v          values of `channels()`
///
/// A sensor type derives from this class; the VSP's shell does all else (`Sampler`). It needs no lock: the VSP's thread
/// makes every call. After `configure()` nothing here but `reconfigure()` allocates, waits or reads a clock; noise
/// comes from `Noise`.
class VirtualSensor {
 public:
  virtual ~VirtualSensor() = default;

  /// Takes the channels that the type's TOML declares and the deployment's parameters; called by the framework, once,
  /// before anything else. `servo_period` in s. Throws as `configure`.
  void set_up(const config::SensorEntry& entry, double servo_period) {
    channels_ = entry.channels;
    raw_channels_ = entry.raw_channels;
    configure(entry, servo_period);
  }
  /// Channels of v, at most kMaxChannels: the declared ones.
  virtual std::vector<Channel> channels() const { return channels_; }
  /// Channels of r, at most kMaxRawValues: the declared ones, or those that the parameters define.
  virtual std::vector<Channel> raw_channels() const { return raw_channels_; }

  /// Takes the deployment's parameters; once, before the calls below. `servo_period` in s. Throws
  /// SystemError(configuration) when they contradict each other.
  virtual void configure(const config::SensorEntry& entry, double servo_period) = 0;

  /// The type's own source, which may pass more than numbers to this object; null: the framework's source (a slot of
  /// the simulated world, a played file). Called once, after `configure()`; the VSP's thread uses the source and
  /// destroys it before this object. A type that lists the source `hardware` opens it here. Throws ConfigurationError
  /// or HardwareError.
  virtual std::unique_ptr<Source> open_source(const SourceContext& /*context*/) { return nullptr; }

  /// True: f_v has a memory (a filter) and needs r at every tick, through `track()`, not only when a reading is due.
  virtual bool continuous() const noexcept { return false; }
  /// r of a tick, for the memory. Called before `bias` and `aggregate` of the same tick; a second call at the same tick
  /// changes nothing. `r` is complete and finite.
  virtual void track(const RawReading& /*r*/) noexcept {}

  /// e_l at the tick of the r that the next `track`, `bias` or `aggregate` gets, where the deployment sends it
  /// (SensorEntry::wants_effector_state).
  virtual void effector_state(const RobotState& /*e*/) noexcept {}

  /// Computes v.values or, when that is impossible, v.error (with `report`). `r` is complete and finite; v's header is
  /// filled in, its error is `none`. Must write every channel or report an error.
  virtual void aggregate(const RawReading& r, SensorReading& v) noexcept = 0;

  /// Defines the values of `r` as zero from now on. When `r` has no valid values (out of range) the zero stays and
  /// `aggregate` of the same r reports why. False: this type has no zero to set.
  virtual bool bias(const RawReading& /*r*/) noexcept { return false; }

  /// Takes a running task's configuration (`Sensor::configure`); the next `track`, `bias` or `aggregate` works with it.
  /// Throws NonFatalError with the reason when it is not possible, and has changed nothing then. May allocate.
  virtual void reconfigure(const Message& configuration) {
    throw NonFatalError(ErrorCode::invalid_argument, std::string("configuration '")
                                                         .append(configuration.label.view())
                                                         .append("', expected none: this type of sensor takes none"));
  }

 private:
  std::vector<Channel> channels_, raw_channels_;
};

}  // namespace mrroc::vsp
