#include "language/cooperation/internal_wrench.hpp"

#include "language/property.hpp"
#include "language/random_values.hpp"

namespace mrroc::internal_wrench_test {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;
using fakes::check_property;
using fakes::pick;
using fakes::random_vector;

constexpr int kWrenchCases = 300;

/// Arms that hold an object at random poses.
struct Grasps {
  std::vector<Vector3d> places;
  double length = 0.01 * pick(5, 100);
  InternalWrench internal;
  Grasps() {
    const int count = pick(2, 5);
    for (int i = 0; i < count; ++i) places.push_back(random_vector(0.5));
    internal = InternalWrench(places, length);
  }
  Eigen::Index size() const { return static_cast<Eigen::Index>(6 * places.size()); }
  /// Force and torque of all arms together about the origin.
  Wrench total(const VectorXd& stack) const {
    Wrench sum = Wrench::Zero();
    for (std::size_t i = 0; i < places.size(); ++i) {
      const Twist part = stack.segment<6>(static_cast<Eigen::Index>(6 * i));
      sum.head<3>() += part.head<3>();
      sum.tail<3>() += length * part.tail<3>() + places[i].cross(Vector3d(part.head<3>()));
    }
    return sum;
  }
  /// The displacements of the grasps of an object that moves by `twist` about the origin.
  VectorXd rigid(const Twist& twist) const {
    VectorXd stack(size());
    for (std::size_t i = 0; i < places.size(); ++i) {
      const Vector3d turn = twist.tail<3>();
      stack.segment<6>(static_cast<Eigen::Index>(6 * i)) << twist.head<3>() + turn.cross(places[i]), length * turn;
    }
    return stack;
  }
  VectorXd random_stack() const {
    VectorXd stack(size());
    for (Eigen::Index i = 0; i < size(); ++i) stack[i] = 0.1 * pick(-100, 100);
    return stack;
  }
  VectorXd of(const VectorXd& stack) const {
    VectorXd part(size());
    internal.of(stack, part);
    return part;
  }
};

TEST(InternalWrench, HasNoEffectOnTheObject) {
  check_property(kWrenchCases, [] {
    const Grasps grasps;
    RC_ASSERT(grasps.total(grasps.of(grasps.random_stack())).norm() < 1e-9);
  });
}

TEST(InternalWrench, WrenchesWithoutEffectOnTheObjectAreInternal) {
  check_property(kWrenchCases, [] {
    const Grasps grasps;
    // any two arms against each other along the line between them, and two torques against each other
    VectorXd stack = VectorXd::Zero(grasps.size());
    const auto last = grasps.size() - 6;
    const Vector3d line = grasps.places.back() - grasps.places.front(), torque = random_vector(5);
    stack.head<3>() = 3 * line;
    stack.segment<3>(last) = -3 * line;
    stack.segment<3>(3) = torque;
    stack.tail<3>() = -torque;
    RC_ASSERT((grasps.of(stack) - stack).norm() < 1e-9);
  });
}

TEST(InternalWrench, CarryingWrenchIsNotInternal) {
  check_property(kWrenchCases, [] {
    const Grasps grasps;
    const VectorXd stack = grasps.random_stack(), part = grasps.of(stack);
    // the remainder has the same wrench and minimum norm: it is orthogonal to every internal wrench
    RC_ASSERT((grasps.total(stack - part) - grasps.total(stack)).norm() < 1e-9);
    RC_ASSERT(std::abs((stack - part).dot(grasps.of(grasps.random_stack()))) < 1e-7);
  });
}

TEST(InternalWrench, ComplianceDoesNotMoveTheObject) {
  check_property(kWrenchCases, [] {
    const Grasps grasps;
    Twist twist;
    twist << random_vector(0.01), random_vector(0.01);
    RC_ASSERT(grasps.of(grasps.rigid(twist)).norm() < 1e-10);
    // so the best rigid fit to the displacements of the arms is zero
    RC_ASSERT(std::abs(grasps.of(grasps.random_stack()).dot(grasps.rigid(twist))) < 1e-9);
  });
}

TEST(InternalWrench, IsHalfTheDifferenceOfTwoArmsAlongTheirLine) {
  check_property(kWrenchCases, [] {
    const Vector3d first = random_vector(0.5), second = first + random_vector(0.5) + Vector3d(0, 0, 1);
    const InternalWrench internal({first, second}, 0.2);
    const Vector3d line = (second - first).normalized(), one = random_vector(50), other = random_vector(50);
    VectorXd stack = VectorXd::Zero(12), part(12);
    stack.head<3>() = one;
    stack.segment<3>(6) = other;
    internal.of(stack, part);
    RC_ASSERT(std::abs(part.head<3>().dot(line) - 0.5 * (one - other).dot(line)) < 1e-9);
    RC_ASSERT(std::abs(part.segment<3>(6).dot(line) + part.head<3>().dot(line)) < 1e-9);
  });
}

TEST(InternalWrench, SqueezeIsRecoveredFromALoad) {
  check_property(kWrenchCases, [] {
    const double arm = 0.01 * pick(5, 60), force = 0.1 * pick(-300, 300);
    const Vector3d middle = random_vector(1);
    const InternalWrench internal({middle + Vector3d(0, arm, 0), middle - Vector3d(0, arm, 0)}, 0.2);
    const VectorXd squeeze = internal.squeeze(force);
    RC_ASSERT(std::abs(squeeze[1] - force) < 1e-9);  // the object pushes the first arm out
    RC_ASSERT(std::abs(squeeze[7] + force) < 1e-9);
    VectorXd stack = squeeze, part(12);
    const Vector3d load = random_vector(100);
    stack.head<3>() += 0.5 * load;
    stack.segment<3>(6) += 0.5 * load;
    internal.of(stack, part);
    RC_ASSERT((part - squeeze).norm() < 1e-9);
  });
}

}  // namespace
}  // namespace mrroc::internal_wrench_test
