// The same main() as the robot's EDP, linked with its simulated drives instead of the servo: it needs the robot's
// model, because the motors are joints of the world.
#include "edp/shell.hpp"

#include <cmath>
#include <memory>
#include <thread>
#include <utility>

#include "can/bus.hpp"
#include "can/hub.hpp"
#include "clock/wall/monotonic.hpp"
#include "clock/wall/wait.hpp"
#include "config/drives/io_table.hpp"
#include "config/robot_place.hpp"
#include "drivers/mujoco/mujoco_hardware.hpp"
#include "mrroc/stopped.hpp"
#include "process/process.hpp"
#include "process/standard_files.hpp"
#include "sim/can/drive_rack.hpp"
#include "sim/can/injected_drives.hpp"
#include "sim/can/injected_io.hpp"
#include "world/mapped_world.hpp"

namespace mrroc::edp {

namespace {

constexpr std::string_view kHub = "unix:";
constexpr std::int64_t kHubTimeout = 60 * clock::kSecond, kBetweenAttempts = clock::kSecond / 50;
constexpr Tick kGlanceTicks = 10;  // without a SYNC, after which the master counts as gone

/// The simulated drives of one robot: the hardware of its EDP, which reaches them by the bus alone.
class Drives {
 public:
  Drives(process::Process& process, const ModelFactory& factory)
      : process_(process),
        place_(config::robot_of_process(process.deployment(), process.name())),
        models_(factory(place_.entry.parameters)),
        world_(world::MappedWorld::attach(process.arguments().world_fd)),
        plant_(*models_.front(), *world_, place_.index, MujocoHardware::Timing::newest, place_.entry.synchronised),
        hub_(open_hub(process.deployment(), place_)),
        bus_(open_bus(process, place_.entry.can->interface)),
        faults_(process.faults().of(process.name(), process.clock()), models_.front()->parameters()),
        table_(config::read_drive_table(place_.entry.can->drives, models_.front()->parameters())),
        io_(io_table(*place_.entry.can, table_)),
        io_faults_(process.faults().of(process.name(), process.clock()), io_),
        rack_(
            table_, models_.front()->parameters(), process.clock().period(), *bus_, plant_,
            [this](Tick last, bool wait, std::int64_t now) { return newest(last, wait, now); },
            process.clock().simulated() ? sim::DriveRack::Time::plant : sim::DriveRack::Time::wall,
            [this](const sim::DriveRack::Cycle& cycle) {
              faults_.apply(cycle.tick, cycle.now, cycle.drives);
              io_faults_.apply(cycle.tick, cycle.now, cycle.io_nodes, cycle.inputs);
            },
            io_) {}

  /// Its own thread serves the bus; this one waits for the end, which comes when no robot is driven any more.
  void serve() {
    await_world();
    std::exception_ptr failure;
    std::thread thread([this, &failure] {
      try {
        rack_.serve();
      } catch (...) {
        failure = std::current_exception();
        process_.clock().interrupt();
      }
    });
    const std::shared_ptr<void> joined(nullptr, [&](void*) {
      rack_.stop();
      thread.join();
    });
    process_.start();
    std::uint64_t cycles = 0;
    for (;;) {
      if (process_.clock().wait(process_.clock().tick() + kGlanceTicks) == clock::Wake::interrupted) break;
      const std::uint64_t now = rack_.cycles();
      links::Counters counters;
      counters.ticks = now;
      process_.status().counters(counters);
      // the master ends first: it waits until its drives report that they are off
      const bool alone = now == std::exchange(cycles, now);
      // in simulated time drives without a master stand still: its ticks are their time
      const bool done = alone && (process_.clock().simulated() || !rack_.powered());
      if (process_.clock().stopping() && done) break;
    }
    if (failure) std::rethrow_exception(failure);
    throw Stopped{};
  }

 private:
  /// The hub of several robots is opened by the drives of the first one.
  static std::unique_ptr<can::Hub> open_hub(const config::Deployment& deployment, const config::RobotPlace& place) {
    const std::string& interface = place.entry.can->interface;
    if (!interface.starts_with(kHub)) return nullptr;
    for (std::size_t i = 0; i < place.index; ++i) {
      const config::RobotEntry& earlier = deployment.robots[i];
      if (earlier.can && earlier.driver.simulated && earlier.can->interface == interface) return nullptr;
    }
    return std::make_unique<can::Hub>(interface.substr(kHub.size()));
  }

  /// Another process may not have opened the hub yet.
  static std::unique_ptr<can::Bus> open_bus(process::Process& process, const std::string& interface) {
    const std::int64_t end = clock::monotonic_ns() + kHubTimeout;
    for (;;) {
      try {
        return can::open_bus(interface);
      } catch (const std::runtime_error&) {
        if (!interface.starts_with(kHub) || clock::monotonic_ns() > end || process.clock().stopping()) throw;
        clock::pause(kBetweenAttempts);
      }
    }
  }

  static config::IoTable io_table(const config::CanEntry& can, const config::DriveTable& drives) {
    return can.io.empty() ? config::IoTable{} : config::read_io_table(can.io, drives);
  }

  /// Waits for the world: without it there are no shafts to measure.
  void await_world() {
    world::JointMeasurement measurement;
    const auto there = [&] { return world_->measurements[place_.index].load(measurement); };
    constexpr std::int64_t kSlice = clock::kSecond / 10;  // between two checks for the end
    while (!process_.clock().stopping() && !world_->measured.wait(there, kSlice)) {
    }
  }

  sim::DriveRack::Newest newest(Tick last, bool wait, std::int64_t now) {
    world::JointMeasurement measurement;
    const auto later = [&] { return world_->measurements[place_.index].load(measurement) && measurement.tick > last; };
    const bool there = later();
    if (process_.clock().simulated()) return {measurement.tick};
    const double period = process_.clock().period() * 1e9;
    if (!there && wait) world_->measured.wait(later, std::llround(period));
    const auto begin =
        static_cast<double>(process_.clock().epoch_ns()) + static_cast<double>(measurement.tick) * period;
    return {measurement.tick, (static_cast<double>(now) - begin) / period};
  }

  process::Process& process_;
  config::RobotPlace place_;
  RobotModels models_;
  world::MappedWorld world_;
  MujocoHardware plant_;
  std::unique_ptr<can::Hub> hub_;  ///< null: the bus is the kernel's
  std::unique_ptr<can::Bus> bus_;
  sim::InjectedDrives faults_;
  config::DriveTable table_;
  config::IoTable io_;
  sim::InjectedIo io_faults_;
  sim::DriveRack rack_;
};

}  // namespace

int run(int argc, char** argv, const ModelFactory& factory) {
  process::open_standard_files();
  return process::run_process(argc, argv, links::ProcessRole::sim, [&factory](process::Process& process) {
    std::make_unique<Drives>(process, factory)->serve();
  });
}

}  // namespace mrroc::edp
