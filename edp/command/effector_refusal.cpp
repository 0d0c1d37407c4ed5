// Checks whether the robot can execute a command in its present state.
#include <algorithm>
#include <cmath>

#include "edp/command/effector.hpp"
#include "edp/safety/error_report.hpp"
#include "geometry/rigid_motion.hpp"

namespace mrroc::edp {

namespace {

// beyond them a unit is wrong
constexpr double kMostLoad = 1000;        // kg
constexpr double kMostLoadDistance = 10;  // m

bool is_possible(const Load& load) noexcept {
  return load.mass >= 0 && load.mass <= kMostLoad && load.centre.norm() <= kMostLoadDistance;
}

}  // namespace

ErrorReport Effector::refusal(const RobotCommand& command) const noexcept {
  if (snapshot_->fault.code != ErrorCode::none) return make_report(snapshot_->fault, models_.parameters());
  if (!snapshot_->enabled())
    return make_report(ErrorClass::non_fatal, ErrorCode::not_enabled, "at tick %llu",
                       static_cast<unsigned long long>(snapshot_->tick));
  if (snapshot_->interruptions != interruptions_told_) return snapshot_->interruption;
  if (command.start_tick > snapshot_->tick + kMaxMotionSteps)
    return make_report(ErrorClass::non_fatal, ErrorCode::invalid_argument, "start_tick %llu, expected at most %llu",
                       static_cast<unsigned long long>(command.start_tick),
                       static_cast<unsigned long long>(snapshot_->tick) + kMaxMotionSteps);
  if (is_change(command.kind)) return refusal_of_change(command);
  if (command.stop.ticks > kMaxMotionSteps)
    return make_report(ErrorClass::non_fatal, ErrorCode::invalid_argument, "a stop of %d ticks, expected 0..%d",
                       int{command.stop.ticks}, int{kMaxMotionSteps});
  if (!std::isfinite(command.stop.rate))
    return make_report(ErrorClass::non_fatal, ErrorCode::not_finite, "rate of the stop is %g", command.stop.rate);
  if (command.with_outputs)
    if (const ErrorReport report = refusal_of_outputs(command.outputs); bad(report)) return report;
  if (command.kind == CommandKind::force && !mount_)
    return make_report(ErrorClass::non_fatal, ErrorCode::invalid_argument,
                       "a force motion of a robot without force_sensor in the deployment");
  const bool of_motors =
      (command.kind == CommandKind::motor && command.relative && command.interpolation != Interpolation::task) ||
      (command.kind == CommandKind::joint_velocity && command.interpolation == Interpolation::motors);
  if (!snapshot_->synchronised && command.kind != CommandKind::hold && !of_motors)
    return make_report(ErrorClass::non_fatal, ErrorCode::not_synchronised,
                       "only relative motor motion, hold and synchronise");
  return {};
}

ErrorReport Effector::refusal_of_outputs(const ControllerIo& outputs) const noexcept {
  for (std::size_t i = 0; i < outputs.analog.size(); ++i)
    if (!std::isfinite(outputs.analog[i]))
      return make_report(ErrorClass::non_fatal, ErrorCode::not_finite, "analogue output %d is %g", static_cast<int>(i),
                         outputs.analog[i]);
  return {};
}

ErrorReport Effector::refusal_of_change(const RobotCommand& command) const noexcept {
  if (forced_ || (!end_.at_rest() && !holding_))
    return make_report(ErrorClass::non_fatal, ErrorCode::busy, "only at rest");
  switch (command.kind) {
    case CommandKind::set_tool:
      if (!is_rigid(command.pose))
        return make_report(ErrorClass::non_fatal, ErrorCode::invalid_argument, "the tool is not a rigid frame");
      return {};
    case CommandKind::use_model:
      if (!snapshot_->synchronised)
        return make_report(ErrorClass::non_fatal, ErrorCode::not_synchronised, "no model before");
      if (command.choice >= models_.size())
        return make_report(ErrorClass::non_fatal, ErrorCode::invalid_argument, "model %d, expected 0..%d",
                           int{command.choice}, static_cast<int>(models_.size()) - 1);
      return {};
    case CommandKind::synchronise:
      if (snapshot_->synchronised)
        return make_report(ErrorClass::non_fatal, ErrorCode::invalid_argument, "already synchronised");
      for (const AxisParameters& axis : models_.parameters().axes)
        if (axis.synchro_coarse == 0 && !snapshot_->drives_home)
          return make_report(ErrorClass::non_fatal, ErrorCode::invalid_argument,
                             "axis %s has no synchronisation switch", axis.name.c_str());
      return {};
    case CommandKind::use_regulators: {
      const std::size_t count = models_.parameters().regulators.size();
      if (command.choice >= count)
        return make_report(ErrorClass::non_fatal, ErrorCode::invalid_argument, "regulator set %d, expected below %d",
                           int{command.choice}, static_cast<int>(count));
      return {};
    }
    case CommandKind::bias_force:
      if (!mount_)
        return make_report(ErrorClass::non_fatal, ErrorCode::invalid_argument,
                           "the robot has no force_sensor in the deployment");
      return {};
    case CommandKind::carry:
      if (!mount_)
        return make_report(ErrorClass::non_fatal, ErrorCode::invalid_argument,
                           "the robot has no force_sensor in the deployment");
      if (!is_possible(command.load))
        return make_report(ErrorClass::non_fatal, ErrorCode::invalid_argument,
                           "a load of %g kg at %g m, expected 0 to %g kg within %g m of the tool frame",
                           command.load.mass, command.load.centre.norm(), kMostLoad, kMostLoadDistance);
      return {};
    default:
      return make_report(ErrorClass::non_fatal, ErrorCode::invalid_argument, "kind %d is unknown",
                         static_cast<int>(command.kind));
  }
}

}  // namespace mrroc::edp
