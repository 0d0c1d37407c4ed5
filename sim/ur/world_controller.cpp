#include "sim/ur/world_controller.hpp"

#include <memory>
#include <string>

#include "clock/wall/monotonic.hpp"
#include "mrroc/stopped.hpp"
#include "sim/ur/world_joints.hpp"
#include "world/mapped_world.hpp"

namespace mrroc::sim::ur {

namespace {

constexpr Tick kGlanceTicks = 10;                     // between two looks at the clients
constexpr std::int64_t kSlice = clock::kSecond / 10;  // between two checks for the end
/// Of the EDP's set-points in lockstep; an EDP that has ended is not awaited.
constexpr std::int64_t kAnswerTimeout = 60 * clock::kSecond;

/// Without the world there are no joints to measure.
void await_world(process::Process& process, world::MappedWorld& world, std::size_t slot) {
  world::JointMeasurement measurement;
  const auto there = [&] { return world->measurements[slot].load(measurement); };
  while (!process.clock().stopping() && !world->measured.wait(there, kSlice)) {
  }
}

void check_period(const clock::Clock& clock, double controller_period) {
  if (clock.period() >= controller_period) return;
  throw SystemError(ErrorCode::configuration, "servo_period is " + std::to_string(clock.period()) +
                                                  " s, expected at least the controller's " +
                                                  std::to_string(controller_period) + " s");
}

void report(process::Process& process, std::uint64_t periods) {
  links::Counters counters;
  counters.ticks = periods;
  process.status().counters(counters);
}

/// On its own clock, beside that of the deployment.
void serve_real(process::Process& process, ControllerServers& servers) {
  clock::Clock& clock = process.clock();
  while (clock.wait(clock.tick() + kGlanceTicks) != clock::Wake::interrupted) {
    report(process, servers.periods());
    // the EDP ends first: its control script stops the arm
    if (clock.stopping() && servers.rtde_clients() == 0) return;
  }
}

/// One period in each tick.
void serve_simulated(process::Process& process, ControllerServers& servers) {
  clock::Clock& clock = process.clock();
  for (Tick tick = 0;; ++tick) {
    // the part `world` wakes while the world steps to this tick
    while (clock.tick() < tick)
      if (clock.wait(tick) == clock::Wake::interrupted) return;
    // in the next delta the world has measured, and the EDP runs beside this process
    if (clock.wait(tick) == clock::Wake::interrupted) return;
    const ControllerServers::Period period = servers.advance(kAnswerTimeout);
    if (period == ControllerServers::Period::unanswered)
      throw SystemError(ErrorCode::process_silent,
                        "the EDP has not sent its set-points within " +
                            std::to_string(kAnswerTimeout / clock::kSecond) + " s of wall time",
                        {.process = process.name(), .device = {}, .tick = tick});
    report(process, tick + 1);
    if (clock.stopping() && period == ControllerServers::Period::without_driver) return;
  }
}

}  // namespace

void serve_world_controller(process::Process& process, const RobotParameters& robot, std::size_t slot,
                            ControllerServers::Options options) {
  const bool simulated = process.clock().simulated();
  if (simulated)
    options.controller.period = process.clock().period();
  else
    options.lockstep_register.reset();
  check_period(process.clock(), options.controller.period);
  world::MappedWorld world = world::MappedWorld::attach(process.arguments().world_fd);
  await_world(process, world, slot);
  ControllerServers servers(options, std::make_unique<WorldJoints>(robot, *world, slot));
  process.start();
  simulated ? serve_simulated(process, servers) : serve_real(process, servers);
  throw Stopped{};
}

}  // namespace mrroc::sim::ur
