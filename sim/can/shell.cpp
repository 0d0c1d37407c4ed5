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
#include "config/drives/io_table.hpp"
#include "config/robot_place.hpp"
#include "drivers/mujoco/mujoco_hardware.hpp"
#include "mrroc/stopped.hpp"
#include "process/process.hpp"
#include "process/standard_files.hpp"
#include "sim/can/drive_rack.hpp"
#include "sim/can/injected_drives.hpp"
#include "world/mapped_world.hpp"

namespace mrroc::edp {

namespace {

constexpr std::string_view kHub = "unix:";
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
        hub_(open_hub(place_.entry.can->interface)),
        bus_(can::open_bus(place_.entry.can->interface)),
        faults_(process.faults().of(process.name(), process.clock()), models_.front()->parameters()),
        table_(config::read_drive_table(place_.entry.can->drives, models_.front()->parameters())),
        rack_(
            table_, models_.front()->parameters(), process.clock().period(), *bus_, plant_,
            [this](Tick last, bool wait, std::int64_t now) { return newest(last, wait, now); },
            process.clock().simulated() ? sim::DriveRack::Time::plant : sim::DriveRack::Time::wall,
            [this](Tick tick, std::int64_t now, auto& nodes) { faults_.apply(tick, now, nodes); },
            io_table(*place_.entry.can, table_)) {}

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
  static std::unique_ptr<can::Hub> open_hub(const std::string& interface) {
    if (!interface.starts_with(kHub)) return nullptr;
    return std::make_unique<can::Hub>(interface.substr(kHub.size()));
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
