#include "mrroc/generators/spiral_search.hpp"

#include <cmath>
#include <limits>

#include "language/free_flyer.hpp"
#include "language/property.hpp"
#include "language/random_values.hpp"
#include "mrroc/conditions/elapsed_steps.hpp"
#include "mrroc/move.hpp"

namespace mrroc::spiral_search_test {
namespace {

using fakes::check_property;
using fakes::FreeFlyer;
using fakes::pick;

TEST(SpiralSearch, PassesEveryPointOfTheDiscAtTheSpeedAndEnds) {
  check_property(50, [] {
    FreeFlyer task(Pose::Identity(), static_cast<std::uint16_t>(pick(1, 10)));
    const double pitch = 1e-4 * pick(2, 10), radius = pitch * pick(3, 8), speed = 1e-3 * pick(1, 4);
    ForceLaw law;
    law.contact(2, -5.0);
    const Outcome end = Move({*task.arm}, {}, SpiralSearch(*task.arm, law, pitch, radius, speed));
    RC_ASSERT(end.ending == Ending::generator);
    std::vector<Eigen::Vector2d> way{Eigen::Vector2d::Zero()};
    for (const RobotCommand& command : task.commands) {
      RC_ASSERT(command.kind == CommandKind::force);
      RC_ASSERT(command.force.behaviour[2] == AxisBehaviour::contact && command.force.wrench[2] == -5.0);
      RC_ASSERT(command.twist.tail<4>().isZero(0));
      const Eigen::Vector2d velocity = command.twist.head<2>();
      RC_ASSERT(velocity.norm() <= speed * 1.02);
      way.push_back(way.back() + velocity * task.arm->step_duration());
    }
    const double length = std::numbers::pi * radius * radius / pitch;  // for many turns
    RC_ASSERT(end.duration > 0.9 * length / speed && end.duration < 1.2 * length / speed + 0.1);
    const double r = 0.01 * pick(0, 90) * radius, phi = 0.01 * pick(0, 628);
    const Eigen::Vector2d place(r * std::cos(phi), r * std::sin(phi));
    double nearest = radius;
    for (const Eigen::Vector2d& point : way) nearest = std::min(nearest, (point - place).norm());
    RC_ASSERT(nearest <= 0.5 * pitch + speed * task.arm->step_duration());
  });
}

TEST(SpiralSearch, RefusesInvalidArguments) {
  FreeFlyer task(Pose::Identity());
  const auto make = [&](double pitch, double radius, double speed) {
    SpiralSearch{*task.arm, ForceLaw{}, pitch, radius, speed};
  };
  EXPECT_NO_THROW(make(1e-3, 1e-2, 1e-2));
  for (const double bad : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_THROW(make(bad, 1e-2, 1e-2), NonFatalError);
    EXPECT_THROW(make(1e-3, bad, 1e-2), NonFatalError);
    EXPECT_THROW(make(1e-3, 1e-2, bad), NonFatalError);
  }
}

}  // namespace
}  // namespace mrroc::spiral_search_test
