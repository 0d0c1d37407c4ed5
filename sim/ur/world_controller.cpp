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

/// Without the world there are no joints to measure.
void await_world(process::Process& process, world::MappedWorld& world, std::size_t slot) {
  world::JointMeasurement measurement;
  const auto there = [&] { return world->measurements[slot].load(measurement); };
  while (!process.clock().stopping() && !world->measured.wait(there, kSlice)) {
  }
}

void check_time(const clock::Clock& clock, double controller_period) {
  if (clock.simulated())
    throw SystemError(ErrorCode::configuration,
                      "a simulated UR controller has its own time: expected clock = \"real\"");
  if (clock.period() < controller_period)
    throw SystemError(ErrorCode::configuration, "servo_period is " + std::to_string(clock.period()) +
                                                    " s, expected at least the controller's " +
                                                    std::to_string(controller_period) + " s");
}

}  // namespace

void serve_world_controller(process::Process& process, const RobotParameters& robot, std::size_t slot,
                            const ControllerServers::Options& options) {
  check_time(process.clock(), options.controller.period);
  world::MappedWorld world = world::MappedWorld::attach(process.arguments().world_fd);
  await_world(process, world, slot);
  ControllerServers servers(options, std::make_unique<WorldJoints>(robot, *world, slot));
  process.start();
  while (process.clock().wait(process.clock().tick() + kGlanceTicks) != clock::Wake::interrupted) {
    links::Counters counters;
    counters.ticks = servers.periods();
    process.status().counters(counters);
    // the EDP ends first: its control script stops the arm
    if (process.clock().stopping() && servers.rtde_clients() == 0) break;
  }
  throw Stopped{};
}

}  // namespace mrroc::sim::ur
