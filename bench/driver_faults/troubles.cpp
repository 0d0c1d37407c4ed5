#include "driver_faults/troubles.hpp"

#include <thread>

namespace mrroc::driver_faults {

namespace {

using sim::ur::VirtualController;

void nothing(Cell&) {}

Trouble of_packages(
    const std::string& name, std::function<void(sim::ur::ControllerServers&)> begin,
    std::function<void(sim::ur::ControllerServers&)> end = [](sim::ur::ControllerServers&) {}) {
  return {name, [begin = std::move(begin)](Cell& cell) { begin(cell.controller.servers); },
          [end = std::move(end)](Cell& cell) { end(cell.controller.servers); }};
}

Trouble of_the_sensor(const std::string& name, const sim::NetftFaults& faults) {
  return {name, [faults](Cell& cell) { cell.sensor.set_faults(faults); },
          [](Cell& cell) { cell.sensor.set_faults({}); }};
}

/// A second driver connects to the same controller, and is refused its registers.
void open_second_master(Cell& cell) {
  const ur::UrOptions options = cell.controller.driver_options();
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
      {"a second master", open_second_master, nothing},
      of_the_sensor("force sensor unplugged", unplugged()),
      {"force sensor restarts", [](Cell& cell) { cell.sensor.restart(); }, nothing},
      of_the_sensor("20 % of the sensor's packets lost", {.loss = 0.2}),
      of_the_sensor("sensor's packets doubled", {.doubled = 0.5}),
      of_the_sensor("sensor's packets overtaken", {.reordered = 0.5}),
      of_the_sensor("garbage from the sensor", {.garbage = 0.5}),
      of_the_sensor("sensor's status word bad", {.status = 0x80000000}),
  };
  return all;
}

}  // namespace mrroc::driver_faults
