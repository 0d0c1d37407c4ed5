#include "process/faulty_robot_link.hpp"

#include <cmath>
#include <limits>

#include "mrroc/stopped.hpp"

namespace mrroc::process {

namespace {

void corrupt(RobotCommand& command) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  command.joints.setConstant(nan);
  command.joint_velocity.setConstant(nan);
  command.pose.translation().setConstant(nan);
  command.twist.setConstant(nan);
}

void leap(RobotCommand& command, double by) {
  command.joints.array() += by;
  command.joint_velocity.array() += by;
  command.pose.translation().array() += by;
  command.twist.array() += by;
}

}  // namespace

void FaultyRobotLink::send(const RobotCommand& command) {
  RobotCommand falsified = command;
  for (const faults::FaultSwitch& each : faults_) {
    if (!each.on(clock_.tick())) continue;
    switch (each.fault().kind) {
      case faults::Kind::lose:
        return;
      case faults::Kind::delay: {
        const Tick until = clock_.tick() + static_cast<Tick>(std::max(0.0, each.fault().value));
        while (clock_.tick() < until)
          if (clock_.wait(until) == clock::Wake::interrupted) throw Stopped{};
        break;
      }
      case faults::Kind::corrupt:
        corrupt(falsified);
        break;
      case faults::Kind::leap:
        leap(falsified, each.fault().value);
        break;
      default:
        break;
    }
  }
  link_.send(falsified);
}

}  // namespace mrroc::process
