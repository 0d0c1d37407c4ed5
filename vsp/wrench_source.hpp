#pragma once

#include <memory>

#include "mrroc/load.hpp"
#include "plugin/plugin.hpp"
#include "vsp/virtual_sensor.hpp"

namespace mrroc::vsp {

/// A virtual sensor whose v begins with a wrench w (N, N m), which a robot's EDP reads in its servo tick as well: the
/// key `force_sensor` of a robot. Its type declares `wrench = true`, and its folder exports it with MRROC_WRENCH_SOURCE
/// (`mrroc_add_sensor(... WRENCH wrench.cpp)`). Of the calls of VirtualSensor the EDP makes `set_up` and `open_source`
/// at its start, and `effector_state`, `track`, `aggregate`, `bias`, `carry` in the
/// servo thread, which allocate nothing, take
/// no lock and never throw.
class WrenchSource : public VirtualSensor {
 public:
  /// The sensor frame in the flange frame of the robot that carries it. After `set_up`.
  virtual Pose mount() const = 0;
  /// The load on the sensor of a complete and finite r, even beyond its range: an estimate of w. Servo thread.
  virtual Wrench load(const RawReading& r) const noexcept = 0;
  /// The tool carries `carried` from now on (`Robot::carry`), its centre in the sensor frame: its weight is no part of
  /// w. Servo thread.
  virtual void carry(const Load& carried) noexcept = 0;
};

using MakeWrenchSource = std::unique_ptr<WrenchSource> (*)();

/// Version of WrenchSource. A library of another version is refused when it is loaded.
inline constexpr std::uint32_t kWrenchSourceVersion = 2;

/// The interface of a wrench source whose factory is `make`.
inline plugin::Interface wrench_source_interface(MakeWrenchSource make) noexcept {
  return {"wrench source", kWrenchSourceVersion,
          plugin::layout_of({sizeof(RawReading), sizeof(SensorReading), sizeof(RobotState), sizeof(SourceContext),
                             sizeof(config::SensorEntry), sizeof(config::Deployment)}),
          reinterpret_cast<void (*)()>(make)};
}

}  // namespace mrroc::vsp

/// Exports a class derived from WrenchSource, with a default constructor. Once, in the source WRENCH of
/// `mrroc_add_sensor`.
#define MRROC_WRENCH_SOURCE(SensorClass)                                                                    \
  static std::unique_ptr<mrroc::vsp::WrenchSource> mrroc_make() { return std::make_unique<SensorClass>(); } \
  MRROC_PLUGIN(mrroc::vsp::wrench_source_interface(mrroc_make))
