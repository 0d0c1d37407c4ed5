#include "mrroc/generators/hold.hpp"

#include <limits>

#include "language/fakes.hpp"
#include "language/property.hpp"
#include "language/random_values.hpp"
#include "mrroc/move.hpp"

namespace mrroc::hold_test {
namespace {

using fakes::check_property;
using fakes::FakeTask;
using fakes::pick;

TEST(Hold, LastsItsTimeRoundedUpToStepsEveryTime) {
  check_property(500, [] {
    FakeTask task;
    const auto arm = task.robot("arm");
    const auto motion_steps = static_cast<std::uint16_t>(pick(1, 30));
    const auto reply_step = static_cast<std::uint16_t>(pick(1, motion_steps));
    arm->set_macrostep(motion_steps, reply_step);
    const int ticks = pick(0, 300);
    Hold hold(*arm, 0.002 * ticks);
    for (int repetition = 0; repetition < 2; ++repetition) {
      const Outcome end = Move({*arm}, {}, hold);
      const auto held = static_cast<int>(end.end_tick - end.start_tick);
      RC_ASSERT(end.ending == Ending::generator);
      RC_ASSERT(held >= ticks);
      RC_ASSERT(held < ticks + 2 * motion_steps);
      for (const fakes::Call& call : task.log.calls) {
        if (call.action == fakes::Action::send) RC_ASSERT(call.kind != CommandKind::joint);
      }
    }
  });
}

TEST(Hold, PauseDoesNotCountAsHoldingTime) {
  FakeTask task;
  const auto arm = task.robot("arm");
  Hold hold(*arm, 0.1);
  const std::uint64_t steps = Move({*arm}, {}, hold).steps;
  task.requests = {OperatorRequest::none};
  task.requests.insert(task.requests.end(), 20, OperatorRequest::pause);
  EXPECT_EQ(Move({*arm}, {}, Hold(*arm, 0.1)).steps, steps);
}

TEST(Hold, RefusesInvalidTimes) {
  FakeTask task;
  const auto arm = task.robot("arm");
  EXPECT_EQ(Move({*arm}, {}, Hold(*arm, 0)).steps, 0u);
  for (const double time : {-0.1, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    EXPECT_THROW(Hold(*arm, time), NonFatalError);
  }
}

}  // namespace
}  // namespace mrroc::hold_test
