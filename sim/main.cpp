#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>

#include "clock/wall/ticker.hpp"
#include "mrroc/errors.hpp"
#include "mrroc/stopped.hpp"
#include "process/process.hpp"
#include "process/standard_files.hpp"
#include "sim/errors/truth_text.hpp"
#include "sim/motion_file.hpp"
#include "sim/removed_material.hpp"
#include "sim/simulation.hpp"
#include "sim/state_file.hpp"
#include "world/mapped_world.hpp"

namespace {

using mrroc::Tick;

/// Ticks between two world snapshots: 0.1 s at 2 ms.
constexpr Tick kSnapshotTicks = 50;

/// Writes the requested records of the world: snapshots and the robots' motion. A failed write does not stop the world,
/// in which robots move: the process fails at its end.
class Records {
 public:
  Records(mrroc::process::Process& process, const mrroc::sim::Simulation& simulation,
          const mrroc::world::WorldMemory& memory)
      : process_(process),
        simulation_(simulation),
        snapshots_(process.arguments().snapshots),
        removed_(process.arguments().snapshots) {
    if (const auto& arguments = process.arguments(); arguments.motion_fd >= 0)
      motion_.emplace(arguments.motion_fd, arguments.motion, process.deployment(), memory);
    if (!snapshots_.empty() && process.deployment().sim->errors) write_truth();
  }
  ~Records() {
    if (!motion_) return;
    if (const std::string problem = motion_->close(); !problem.empty()) process_.fail_at_end(problem);
  }
  Records(const Records&) = delete;
  Records& operator=(const Records&) = delete;

  void write(Tick tick) {
    if (motion_) motion_->write(tick);
    if (snapshots_.empty()) return;
    std::string name = std::to_string(tick);
    name.insert(0, 8 - std::min<std::size_t>(8, name.size()), '0');
    try {
      removed_.write(simulation_.world(), tick);
      if (tick % kSnapshotTicks != 0) return;
      mrroc::sim::save_state(snapshots_ / (name + ".state"), simulation_.state());
    } catch (const mrroc::SystemError& error) {
      process_.fail_at_end(error.what());
      snapshots_.clear();
    }
  }

 private:
  void write_truth() {
    const std::filesystem::path file = snapshots_ / "errors.toml";
    std::ofstream out(file);
    out << mrroc::sim::truth_text(process_.deployment(), simulation_.world().model());
    out.close();
    if (!out) process_.fail_at_end("cannot write " + file.string());
  }

  mrroc::process::Process& process_;
  const mrroc::sim::Simulation& simulation_;
  std::filesystem::path snapshots_;
  mrroc::sim::RemovedMaterial removed_;
  std::optional<mrroc::sim::MotionFile> motion_;
};

/// MuJoCo's warnings, each once, on stderr.
class Warnings {
 public:
  void tell(mrroc::sim::World& world) {
    for (; told_ < world.warnings().size(); ++told_) {
      const mrroc::sim::WorldWarning& warning = world.warnings()[told_];
      std::fprintf(stderr, "warning at tick %llu: %s\n", static_cast<unsigned long long>(warning.first_tick),
                   warning.text.c_str());
    }
  }

 private:
  std::size_t told_ = 0;
};

/// Lockstep and paced: one step per tick, until no robot is driven any more when the deployment ends.
void serve_simulated(mrroc::process::Process& process, mrroc::sim::Simulation& simulation, Records& records) {
  Warnings warnings;
  for (Tick next = 1;; ++next) {
    while (process.clock().tick() < next) {
      if (process.clock().wait(next) == mrroc::clock::Wake::interrupted) throw mrroc::Stopped{};
    }
    simulation.step(next);
    warnings.tell(simulation.world());
    records.write(next);
    if (process.clock().stopping() && !simulation.driven()) throw mrroc::Stopped{};
  }
}

/// Real time: how far the world may fall behind the wall clock, s.
constexpr double kMostBehind = 2.0;

void check_pace(Tick simulated, const mrroc::clock::Clock& clock) {
  const double behind = static_cast<double>(clock.tick() - std::min(simulated, clock.tick())) * clock.period();
  if (behind <= kMostBehind) return;
  throw mrroc::SystemError(mrroc::ErrorCode::simulator,
                           "the world is " + std::to_string(behind) + " s behind the wall clock, expected at most " +
                               std::to_string(kMostBehind) + " s: too slow a scene or machine for clock = \"real\"",
                           {.process = "sim", .device = {}, .tick = simulated});
}

/// Real time: one step per tick of the grid, each after the drives of the tick before. A late step is still made: the
/// world loses no time. When it is asked to end it continues while a robot is driven: it is the robots' hardware, and
/// they need it to stop.
void serve_real(mrroc::process::Process& process, mrroc::sim::Simulation& simulation, Records& records) {
  mrroc::clock::Ticker ticker(process.clock().epoch_ns(), std::llround(process.clock().period() * 1e9));
  Tick simulated = 0;
  Warnings warnings;
  for (;;) {
    const Tick tick = ticker.wait_next();
    while (simulated < tick) {
      simulation.step_in_real_time(++simulated);
      records.write(simulated);
      warnings.tell(simulation.world());
      // the tick has come: this does not wait, it only reports when the process must end
      const bool ending = process.clock().wait(simulated) == mrroc::clock::Wake::interrupted;
      if ((ending || process.clock().stopping()) && !simulation.driven()) throw mrroc::Stopped{};
      check_pace(simulated, process.clock());
    }
    mrroc::links::Counters counters;
    counters.ticks = ticker.statistics().ticks();
    counters.missed_ticks = ticker.statistics().missed();
    process.status().counters(counters);
  }
}

void serve(mrroc::process::Process& process) {
  const mrroc::world::MappedWorld world = mrroc::world::MappedWorld::attach(process.arguments().world_fd);
  mrroc::sim::Simulation simulation(process.deployment(), *world);
  Records records(process, simulation, *world);
  simulation.publish_initial();
  process.start();
  if (process.clock().simulated()) {
    serve_simulated(process, simulation, records);
  } else {
    serve_real(process, simulation, records);
  }
}

}  // namespace

int main(int argc, char** argv) {
  mrroc::process::open_standard_files();
  return mrroc::process::run_process(argc, argv, mrroc::links::ProcessRole::sim, serve);
}
