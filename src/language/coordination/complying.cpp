#include "mrroc/generators/complying.hpp"

#include "core/require.hpp"
#include "geometry/moving_pose.hpp"
#include "language/coordination/displacement.hpp"
#include "language/force/force_step.hpp"
#include "language/limits.hpp"
#include "language/tool_motion.hpp"
#include "mrroc/task.hpp"

namespace mrroc {

struct Complying::Law {
  Robot& robot;
  Compliance compliance;
  Displacement displacement;

  void check_range() const {
    const double way = displacement.value().head<3>().norm(), turn = displacement.value().tail<3>().norm();
    const bool linear = way > compliance.travel;
    if (!linear && turn <= compliance.turn) return;
    const double most = linear ? 1000 * compliance.travel : compliance.turn, found = linear ? 1000 * way : turn;
    const char* const unit = linear ? " mm" : " rad";
    throw NonFatalError(ErrorCode::force_limit,
                        "Complying: the tool would have to give way by " + number_text(found, most) + unit +
                            ", limit " + number_text(most, found) + unit,
                        {robot.task().process_name(), robot.name(), 0, robot.state().tick});
  }
};

Complying::Complying(Superior& superior, Robot& robot, const Compliance& compliance)
    : Coordinated("Complying", superior), law_(new Law{robot, compliance, {}}) {
  for (Eigen::Index i = 0; i < 6; ++i) {
    require_not_negative("Complying", "admittance", compliance.admittance[i]);
    require_not_negative("Complying", "stiffness", compliance.stiffness[i]);
    require_finite("Complying", "desired wrench", compliance.wrench[i]);
  }
  require_above_zero("Complying", "lag", compliance.lag);
  require_above_zero("Complying", "acceleration", compliance.acceleration);
  require_above_zero("Complying", "angular acceleration", compliance.angular_acceleration);
  require_above_zero("Complying", "travel", compliance.travel);
  require_above_zero("Complying", "turn", compliance.turn);
  check_load("Complying", compliance.load, compliance.gravity);
}

Complying::~Complying() = default;

void Complying::start() { resume(); }

void Complying::resume() { law_->displacement.reset(); }

void Complying::next_state() {
  Law& law = *law_;
  const Compliance& c = law.compliance;
  if (law.robot.state().at_rest()) law.displacement.halt();  // after a hold
  const Wrench felt = felt_without(law.robot.state(), c.load, c.gravity);
  if (!felt.allFinite())
    throw NonFatalError(ErrorCode::not_finite, "Complying: the measured wrench",
                        {law.robot.task().process_name(), law.robot.name(), 0, law.robot.state().tick});
  const Wrench spring = c.stiffness.cwiseProduct(law.displacement.value());
  law.displacement.advance(c.admittance.cwiseProduct(felt - c.wrench - spring), c.lag, law.robot.step_duration(),
                           {c.acceleration, c.angular_acceleration});
  law.check_range();
  law.displacement.command(law.robot, superior().command(), "Complying");
}

ForceLaw::Axes Complying::displacement() const noexcept { return law_->displacement.value(); }

}  // namespace mrroc
