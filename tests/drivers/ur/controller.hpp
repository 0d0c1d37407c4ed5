#pragma once

#include <memory>

#include "drivers/ur/six_joints.hpp"
#include "drivers/ur/ur_hardware.hpp"
#include "sim/ur/controller_servers.hpp"

namespace mrroc::ur {

using sim::ur::ControllerServers;
using sim::ur::ExactJoints;
using sim::ur::Six;
using sim::ur::VirtualController;
using Interface = DriveParameters::Interface;

inline constexpr double kPeriod = 0.002;
inline constexpr double kGear = 100;

inline ControllerServers::Options free_ports() {
  ControllerServers::Options options;
  options.rtde_port = options.dashboard_port = options.primary_port = options.secondary_port = options.realtime_port =
      0;
  options.controller.unlock_delay = 0.2;
  return options;
}

/// A simulated controller on free ports.
class Controller {
 public:
  explicit Controller(const ControllerServers::Options& options = free_ports())
      : servers(options, std::make_unique<ExactJoints>(Six{0, -1.5, 1.5, -1.5, -1.5, 0})) {}

  UrOptions driver_options() const {
    UrOptions options;
    options.address = "127.0.0.1";
    options.rtde_port = servers.ports().rtde;
    options.dashboard_port = servers.ports().dashboard;
    options.script_port = servers.ports().secondary;
    options.script = MRROC_SOURCE_DIR "/drivers/ur/control.script";
    options.watchdog = 1;  // of a busy machine's test
    options.missed_max = 250;
    return options;
  }

  /// A value of the controller between two of its periods.
  template <class Get>
  auto ask(Get get) {
    decltype(get(std::declval<VirtualController&>())) value{};
    servers.with([&](VirtualController& controller) { value = get(controller); });
    return value;
  }

  ControllerServers servers;
};

}  // namespace mrroc::ur
