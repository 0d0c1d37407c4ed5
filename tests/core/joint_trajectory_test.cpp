#include "mrroc/joint_trajectory.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>

namespace mrroc::joint_trajectory_test {
namespace {

using Order = JointTrajectory::Order;

JointTrajectory some(std::size_t axes, Order order, std::size_t points) {
  JointTrajectory trajectory(axes, order, points);
  double value = 1;
  for (std::size_t point = 0; point < points; ++point) {
    std::vector<double> values;
    for (std::size_t i = 0; i < axes * static_cast<std::size_t>(order); ++i)
      values.push_back(point + 1 == points && i >= axes ? 0 : ++value);
    trajectory.set_point(point, static_cast<double>(point) + 0.5, values);
  }
  return trajectory;
}

RC_GTEST_PROP(JointTrajectory, ArrivesInPartsAsItWasSent, ()) {
  const auto axes = *rc::gen::inRange<std::size_t>(1, 9);
  const auto order = static_cast<Order>(*rc::gen::inRange(1, 4));
  const JointTrajectory sent = some(axes, order, *rc::gen::inRange<std::size_t>(1, 60));
  JointTrajectory received;
  const auto numbers = sent.numbers();
  for (std::size_t begin = 0; begin < numbers.size();) {
    RC_ASSERT(!received.complete());
    const auto count = std::min(*rc::gen::inRange<std::size_t>(1, 100), numbers.size() - begin);
    RC_ASSERT(received.receive(numbers.size(), begin, numbers.subspan(begin, count)));
    begin += count;
  }
  RC_ASSERT(received.complete());
  RC_ASSERT(received.problem(axes) == nullptr);
  RC_ASSERT(std::vector<double>(numbers.begin(), numbers.end()) ==
            std::vector<double>(received.numbers().begin(), received.numbers().end()));
  RC_ASSERT(received.problem(axes + 1) != nullptr);
}

TEST(JointTrajectory, APartThatIsNotTheNextIsRefused) {
  const JointTrajectory sent = some(6, Order::velocities, 20);
  const auto numbers = sent.numbers();
  JointTrajectory received;
  EXPECT_FALSE(received.receive(numbers.size(), 5, numbers.subspan(5, 5)));
  EXPECT_TRUE(received.receive(numbers.size(), 0, numbers.first(5)));
  EXPECT_FALSE(received.receive(numbers.size(), 6, numbers.subspan(6, 5)));
  EXPECT_FALSE(received.receive(numbers.size() + 1, 5, numbers.subspan(5, 5)));
  EXPECT_FALSE(received.receive(numbers.size(), 5, numbers));
  EXPECT_FALSE(received.receive(numbers.size(), 5, {}));
  EXPECT_FALSE(received.complete());
}

/// Numbers as they may come from anywhere: nothing is read outside of them.
RC_GTEST_PROP(JointTrajectory, AnyNumbersAreJudged, ()) {
  const JointTrajectory good = some(2, Order::accelerations, 3);
  std::vector<double> numbers(good.numbers().begin(), good.numbers().end());
  const auto at = *rc::gen::inRange<std::size_t>(0, numbers.size());
  numbers[at] =
      *rc::gen::element(-1.0, 0.0, 0.5, 2.5, 4.0, 2001.0, 1e300, std::nan(""), std::numeric_limits<double>::infinity());
  numbers.resize(*rc::gen::inRange<std::size_t>(1, numbers.size() + 1));
  JointTrajectory received;
  RC_ASSERT(received.receive(numbers.size(), 0, numbers));
  if (received.problem(2) != nullptr) return;
  RC_ASSERT(received.points() >= 1 && received.points() <= JointTrajectory::kMostPoints);
  RC_ASSERT(std::isfinite(received.acceleration(received.points() - 1, 1)));
}

}  // namespace
}  // namespace mrroc::joint_trajectory_test
