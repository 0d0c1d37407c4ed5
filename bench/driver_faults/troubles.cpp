#include "driver_faults/troubles.hpp"

#include <thread>
#include <utility>

#include "driver_faults/bus_device.hpp"
#include "driver_faults/ur_device.hpp"

namespace mrroc::driver_faults {

namespace {

using sim::ur::VirtualController;

template <class Kind>
Trouble trouble(
    const std::string& name, std::function<void(Kind&)> begin, std::function<void(Kind&)> end = [](Kind&) {}) {
  return {name, [] { return std::make_unique<Kind>(); },
          [begin = std::move(begin)](Device& device) { begin(static_cast<Kind&>(device)); },
          [end = std::move(end)](Device& device) { end(static_cast<Kind&>(device)); }};
}

Trouble of_packages(
    const std::string& name, std::function<void(sim::ur::ControllerServers&)> begin,
    std::function<void(sim::ur::ControllerServers&)> end = [](sim::ur::ControllerServers&) {}) {
  return trouble<UrDevice>(
      name, [begin = std::move(begin)](UrDevice& device) { begin(device.controller.servers); },
      [end = std::move(end)](UrDevice& device) { end(device.controller.servers); });
}

Trouble of_the_sensor(const std::string& name, const sim::NetftFaults& faults) {
  return trouble<UrDevice>(
      name, [faults](UrDevice& device) { device.sensor.set_faults(faults); },
      [](UrDevice& device) { device.sensor.set_faults({}); });
}

Trouble of_an_io_node(
    const std::string& name, std::function<void(sim::IoNode&)> begin,
    std::function<void(sim::IoNode&)> end = [](sim::IoNode&) {}) {
  return trouble<BusDevice>(
      name, [begin = std::move(begin)](BusDevice& device) { device.with_node(begin); },
      [end = std::move(end)](BusDevice& device) { device.with_node(end); });
}

/// A second driver connects to the same controller, and is refused its registers.
void open_second_master(UrDevice& device) {
  const ur::UrOptions options = device.controller.driver_options();
  std::thread([options] {
    ur::SixJoints model(ur::Interface::position);
    ur::UrOptions own = options;
    own.open_timeout = 0.01;
    try {
      ur::UrHardware(own, model, ur::kPeriod).open();
    } catch (const Error&) {  // as it should be
    }
  }).detach();
}

sim::NetftFaults unplugged() {
  sim::NetftFaults faults;
  faults.silent = faults.deaf = true;
  return faults;
}

}  // namespace

const std::vector<Trouble>& troubles() {
  using Servers = sim::ur::ControllerServers;
  static const std::vector<Trouble> all{
      of_packages("connection cut", [](Servers& s) { s.cut(); }),
      of_packages(
          "network gone", [](Servers& s) { s.refuse(true); }, [](Servers& s) { s.refuse(false); }),
      of_packages(
          "packages 5 periods late", [](Servers& s) { s.postpone(5); }, [](Servers& s) { s.postpone(0); }),
      of_packages("packages in bunches of 8", [](Servers& s) { s.delay(8); }),
      of_packages("packages doubled", [](Servers& s) { s.repeat(60); }),
      of_packages(
          "1 % of the packages lost", [](Servers& s) { s.lose_every(100); }, [](Servers& s) { s.lose_every(0); }),
      of_packages(
          "5 % of the packages lost", [](Servers& s) { s.lose_every(20); }, [](Servers& s) { s.lose_every(0); }),
      of_packages(
          "20 % of the packages lost", [](Servers& s) { s.lose_every(5); }, [](Servers& s) { s.lose_every(0); }),
      of_packages("20 packages lost in a row", [](Servers& s) { s.lose(20); }),
      of_packages("60 packages lost in a row", [](Servers& s) { s.lose(60); }),
      of_packages("garbage", [](Servers& s) { s.send_garbage(); }),
      of_packages("controller restarts", [](Servers& s) { s.restart(); }),
      of_packages("protective stop", [](Servers& s) { s.with([](VirtualController& c) { c.protective_stop(); }); }),
      of_packages(
          "emergency stop", [](Servers& s) { s.with([](VirtualController& c) { c.emergency_stop(true); }); },
          [](Servers& s) { s.with([](VirtualController& c) { c.emergency_stop(false); }); }),
      trouble<UrDevice>("a second master", open_second_master),
      of_the_sensor("force sensor unplugged", unplugged()),
      trouble<UrDevice>("force sensor restarts", [](UrDevice& device) { device.sensor.restart(); }),
      of_the_sensor("20 % of the sensor's packets lost", {.loss = 0.2}),
      of_the_sensor("sensor's packets doubled", {.doubled = 0.5}),
      of_the_sensor("sensor's packets overtaken", {.reordered = 0.5}),
      of_the_sensor("garbage from the sensor", {.garbage = 0.5}),
      of_the_sensor("sensor's status word bad", {.status = 0x80000000}),
      of_an_io_node(
          "I/O node gone", [](sim::IoNode& node) { node.cut(true); }, [](sim::IoNode& node) { node.cut(false); }),
      of_an_io_node("I/O node restarts", [](sim::IoNode& node) { node.boot(0); }),
  };
  return all;
}

}  // namespace mrroc::driver_faults
