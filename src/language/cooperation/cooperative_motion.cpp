#include "mrroc/generators/cooperative_motion.hpp"

#include <cmath>
#include <string>
#include <utility>

#include "core/require.hpp"
#include "geometry/rigid_motion.hpp"
#include "language/cooperation/cooperative_plan.hpp"

namespace mrroc {

namespace {

void check(const std::vector<CooperatingArm>& arms) {
  const auto refuse = [](const char* what) { throw NonFatalError(ErrorCode::invalid_argument, what); };
  if (arms.empty()) refuse("CooperativeMotion without an arm");
  for (std::size_t i = 0; i < arms.size(); ++i) {
    if (arms[i].robot == nullptr) refuse("CooperativeMotion: an arm without a robot");
    if (!is_rigid(arms[i].base)) refuse("CooperativeMotion: a base is not a rigid pose");
    if (!arms[i].wrench != !arms[0].wrench) refuse("CooperativeMotion: a wrench of some arms only");
    for (std::size_t j = 0; j < i; ++j)
      if (arms[i].robot == arms[j].robot) refuse("CooperativeMotion: an arm is listed twice");
  }
}

}  // namespace

struct CooperativeMotion::Plan : CooperativePlan {
  using CooperativePlan::CooperativePlan;
};

CooperativeMotion::CooperativeMotion(std::vector<CooperatingArm> arms, const std::vector<Pose>& path,
                                     const CooperativeLimits& limits, const InternalForce& internal)
    : Generator("CooperativeMotion") {
  check(arms);
  require_finite("CooperativeMotion", "squeeze", internal.squeeze);
  require_not_negative("CooperativeMotion", "admittance", internal.admittance);
  require_above_zero("CooperativeMotion", "length", internal.length);
  require_above_zero("CooperativeMotion", "lag", internal.lag);
  require_above_zero("CooperativeMotion", "travel", internal.travel);
  require_above_zero("CooperativeMotion", "limit", internal.limit);
  plan_ = std::make_unique<Plan>(std::move(arms), path, limits, internal);
}

CooperativeMotion::~CooperativeMotion() = default;
CooperativeMotion::CooperativeMotion(CooperativeMotion&&) noexcept = default;
CooperativeMotion& CooperativeMotion::operator=(CooperativeMotion&&) noexcept = default;

double CooperativeMotion::duration() const noexcept { return plan_->duration(); }
const Pose& CooperativeMotion::object() const noexcept { return plan_->object(); }
double CooperativeMotion::internal_force() const noexcept { return plan_->internal_force(); }
double CooperativeMotion::internal_torque() const noexcept { return plan_->internal_torque(); }

void CooperativeMotion::start() { plan_->start(); }
void CooperativeMotion::resume() { plan_->resume(); }
bool CooperativeMotion::brake() {
  plan_->brake();
  return true;
}
bool CooperativeMotion::terminal_condition() { return plan_->ended(); }

void CooperativeMotion::next_state() {
  plan_->measure();
  plan_->give_way();
  for (std::size_t i = 0; i < plan_->size(); ++i) plan_->command(i);
  plan_->advance();
}

}  // namespace mrroc
