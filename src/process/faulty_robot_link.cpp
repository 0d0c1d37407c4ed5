#include "process/faulty_robot_link.hpp"

#include <algorithm>
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

void FaultyRobotLink::wait_until(Tick tick) {
  while (clock_.tick() < tick)
    if (clock_.wait(tick) == clock::Wake::interrupted) throw Stopped{};
}

void FaultyRobotLink::receive(RobotState& state) {
  if (missed_at_ != kNever) {
    wait_until(missed_at_);
    throw SystemError(ErrorCode::process_silent, "no answer to a command that was lost", {{}, {}, 0, clock_.tick()});
  }
  link_.receive(state);
}

void FaultyRobotLink::send(const RobotCommand& command) {
  RobotCommand falsified = command;
  for (const faults::FaultSwitch& each : faults_) {
    if (!each.on(clock_.tick())) continue;
    switch (each.fault().kind) {
      case faults::Kind::lose:
        missed_at_ = command.reply_tick(0, clock_.tick()) + patience_;
        return;
      case faults::Kind::delay:
        wait_until(clock_.tick() + static_cast<Tick>(each.fault().value));
        break;
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
