#include "mrroc/generators/impedance.hpp"

#include <limits>

#include "language/force/force_flyer.hpp"
#include "language/property.hpp"
#include "language/random_values.hpp"
#include "mrroc/conditions/elapsed_steps.hpp"
#include "mrroc/move.hpp"

namespace mrroc::impedance_test {
namespace {

using Eigen::Vector3d;
using fakes::check_property;
using fakes::ForceFlyer;
using fakes::pick;
using fakes::random_vector;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

Pose random_pose() {
  Pose pose = Pose::Identity();
  pose.translation() = random_vector(0.5);
  pose.linear() = exp_rotation(random_vector(1.5));
  return pose;
}

/// A spring and damper with a permitted stiffness, overdamped or oscillating.
ImpedanceParameters random_parameters(double step) {
  ImpedanceParameters parameters;
  for (Eigen::Index i = 0; i < 6; ++i) {
    const double scale = i < 3 ? 1 : 0.02;
    parameters.damping[i] = scale * pick(50, 300);
    const double rate = 0.1 * pick(5, 80);  // K / D, 1/s
    parameters.stiffness[i] = parameters.damping[i] * std::min(rate, Impedance::kStiffest / step);
    parameters.inertia[i] = scale * 0.1 * pick(1, 200);
  }
  parameters.speed = 10;
  parameters.angular_speed = 10;
  return parameters;
}

/// M x'' + D x' + K x = F of one axis, x(0) = x0 and x'(0) = 0: Runge-Kutta integration in steps of 0.1 ms.
struct Oscillator {
  double m, d, k, force, x, v = 0;
  void advance(double seconds) {
    constexpr double h = 1e-4;
    const auto a = [this](double x_, double v_) { return (force - d * v_ - k * x_) / m; };
    for (double t = 0; t < seconds - 0.5 * h; t += h) {
      const double k1x = v, k1v = a(x, v), k2x = v + h / 2 * k1v, k2v = a(x + h / 2 * k1x, v + h / 2 * k1v);
      const double k3x = v + h / 2 * k2v, k3v = a(x + h / 2 * k2x, v + h / 2 * k2v), k4x = v + h * k3v,
                   k4v = a(x + h * k3x, v + h * k3v);
      x += h / 6 * (k1x + 2 * k2x + 2 * k3x + k4x);
      v += h / 6 * (k1v + 2 * k2v + 2 * k3v + k4v);
    }
  }
};

TEST(Impedance, MovesLikeAMassOnASpringAndADamper) {
  check_property(60, [] {
    // one axis at a time, so that the exact solution is that of one equation
    const auto n = static_cast<std::uint16_t>(pick(1, 10));
    const Pose home = random_pose();
    const int axis = pick(0, 5);
    const double scale = axis < 3 ? 1 : 2;
    const double force = (axis < 3 ? 1 : 0.02) * pick(-30, 30);
    const double offset = scale * 0.001 * pick(-50, 50);
    Twist displacement = Twist::Zero();
    displacement[axis] = offset;
    ForceFlyer task(home * exp_twist(displacement), {}, n, static_cast<std::uint16_t>(pick(1, n)));
    // a force that turns with the tool
    task.felt = [&](const Pose&, const Twist&) {
      Wrench wrench = Wrench::Zero();
      wrench[axis] = force;
      return wrench;
    };
    const double step = task.arm->step_duration();
    const ImpedanceParameters parameters = random_parameters(step);
    Oscillator exact{parameters.inertia[axis], parameters.damping[axis], parameters.stiffness[axis], force, offset};
    double largest = std::abs(offset), worst = 0;
    task.on_tick = [&](Tick, const Wrench&) {
      exact.advance(task.servo_period());
      const Pose off = home.inverse() * task.pose;
      Twist now;
      now << off.translation(), rotation_vector(off.linear());
      largest = std::max(largest, std::abs(exact.x));
      worst = std::max(worst, std::abs(now[axis] - exact.x));
      now[axis] = 0;
      RC_ASSERT(now.norm() < 1e-9);
    };
    const auto steps = static_cast<std::uint64_t>(2.0 / step);
    Move({*task.arm}, {}, Impedance{*task.arm, home, parameters}.until(ElapsedSteps{steps}));
    RC_ASSERT(worst <= 0.08 * largest + 1e-6);
    // it ends where the spring balances the force
    exact.advance(10);
    Move({*task.arm}, {},
         Impedance{*task.arm, home, parameters}.until(ElapsedSteps{static_cast<std::uint64_t>(15 / step)}));
    const Pose off = home.inverse() * task.pose;
    const double rest = axis < 3 ? off.translation()[axis] : rotation_vector(off.linear())[axis - 3];
    RC_ASSERT(std::abs(rest - force / parameters.stiffness[axis]) <=
              0.02 * std::abs(force / parameters.stiffness[axis]) + 1e-5);
  });
}

TEST(Impedance, FollowsAMovingSetPointWithoutALag) {
  check_property(40, [] {
    const Pose home = random_pose();
    const Vector3d velocity = random_vector(0.05), turning = random_vector(0.1);
    ForceFlyer task(home, [](const Pose&, const Twist&) { return Wrench{Wrench::Zero()}; });
    const auto set_point = [&](double t) {
      MovingFrame frame;
      frame.pose.translation() = home.translation() + t * velocity;
      frame.pose.linear() = exp_rotation(t * turning) * home.linear();
      frame.twist << velocity, turning;
      return frame;
    };
    Tick first = 0;
    double last = 0;
    task.on_tick = [&](Tick tick, const Wrench&) {
      if (first == 0) first = tick - 1;
      const Pose wanted = set_point(static_cast<double>(tick - first) * task.servo_period()).pose;
      last = std::max((wanted.translation() - task.pose.translation()).norm(),
                      0.1 * rotation_vector(wanted.linear().transpose() * task.pose.linear()).norm());
    };
    Move({*task.arm}, {}, Impedance{*task.arm, set_point}.until(ElapsedSteps{150}));
    RC_ASSERT(last < 1e-4);
  });
}

TEST(Impedance, PressesASurfaceWithTheSpringsForce) {
  check_property(40, [] {
    const double depth = 0.001 * pick(2, 15);
    Pose home = Pose::Identity();
    home.linear() = exp_rotation({std::numbers::pi, 0, 0});  // z down
    home.translation().z() = -depth;                         // the set-point is inside
    Pose above = home;
    above.translation().z() = 0.01;
    ForceFlyer task(above, fakes::plane({0, 0, 0}, {0, 0, 1}, 20000));
    ImpedanceParameters parameters;
    parameters.stiffness[2] = 100 * pick(5, 20);
    Move({*task.arm}, {}, Impedance{*task.arm, home, parameters}.until(ElapsedSteps{400}));
    const double pressed = -task.arm->state().wrench[2];
    const double series = parameters.stiffness[2] * 20000 / (parameters.stiffness[2] + 20000);
    RC_ASSERT(std::abs(pressed - series * depth) < 0.02 * series * depth);
  });
}

TEST(Impedance, LoadDoesNotDeflectIt) {
  check_property(40, [] {
    const Pose home = random_pose();
    const Load load{0.1 * pick(1, 50), random_vector(0.1)};
    ForceFlyer task(home, [&](const Pose& pose, const Twist&) { return weight_of(load, pose.linear()); });
    ImpedanceParameters parameters;
    parameters.load = load;
    Move({*task.arm}, {}, Impedance{*task.arm, home, parameters}.until(ElapsedSteps{100}));
    RC_ASSERT((task.pose.translation() - home.translation()).norm() < 1e-6);
    parameters.load = {};
    Move({*task.arm}, {}, Impedance{*task.arm, home, parameters}.until(ElapsedSteps{200}));
    const double sag = load.mass * 9.81 / 500;
    RC_ASSERT((task.pose.translation() - home.translation()).norm() > 0.5 * sag);
  });
}

TEST(Impedance, ReturnsFromFarWithoutExceedingItsSpeed) {
  Pose far = Pose::Identity();
  far.translation() << 0.5, -0.3, 0.2;
  ForceFlyer task(far, [](const Pose&, const Twist&) { return Wrench{Wrench::Zero()}; });
  double fastest = 0;
  task.on_tick = [&](Tick, const Wrench&) { fastest = std::max(fastest, task.twist.head<3>().norm()); };
  ImpedanceParameters parameters;
  parameters.speed = 0.08;
  Move({*task.arm}, {}, Impedance{*task.arm, Pose::Identity(), parameters}.until(ElapsedSteps{1000}));
  EXPECT_LE(fastest, 0.08 + 1e-9);
  EXPECT_GT(fastest, 0.079);
  EXPECT_LT(task.pose.translation().norm(), 1e-4);
}

TEST(Impedance, MovingSetPointContinuesAfterAPause) {
  ForceFlyer task(Pose::Identity(), [](const Pose&, const Twist&) { return Wrench{Wrench::Zero()}; });
  std::vector<double> times;
  const auto set_point = [&](double t) {
    times.push_back(t);
    return MovingFrame{};
  };
  task.requests.assign(20, OperatorRequest::none);
  for (int i = 0; i < 50; ++i) task.requests.push_back(OperatorRequest::pause);
  Move({*task.arm}, {}, Impedance{*task.arm, set_point}.until(ElapsedSteps{40}));
  ASSERT_EQ(times.size(), 40u);
  for (std::size_t i = 0; i < times.size(); ++i)
    EXPECT_NEAR(times[i], (static_cast<double>(i) + 0.5) * task.arm->step_duration(), 1e-9);
}

TEST(Impedance, RefusesInvalidArguments) {
  ForceFlyer task(Pose::Identity(), [](const Pose&, const Twist&) { return Wrench{Wrench::Zero()}; });
  const auto with = [&](auto change) {
    ImpedanceParameters parameters;
    change(parameters);
    Impedance{*task.arm, Pose::Identity(), parameters};
  };
  EXPECT_NO_THROW(with([](auto&) {}));
  for (const double bad : {-1.0, kNan}) {
    EXPECT_THROW(with([&](auto& p) { p.stiffness[3] = bad; }), NonFatalError);
    EXPECT_THROW(with([&](auto& p) { p.inertia[0] = bad; }), NonFatalError);
    EXPECT_THROW(with([&](auto& p) { p.load.mass = bad; }), NonFatalError);
  }
  for (const double bad : {0.0, -1.0, kNan}) {
    EXPECT_THROW(with([&](auto& p) { p.damping[5] = bad; }), NonFatalError);
    EXPECT_THROW(with([&](auto& p) { p.speed = bad; }), NonFatalError);
    EXPECT_THROW(with([&](auto& p) { p.angular_speed = bad; }), NonFatalError);
  }
  Pose sheared = Pose::Identity();
  sheared.linear()(0, 1) = 0.1;
  EXPECT_THROW((Impedance{*task.arm, sheared}), NonFatalError);
  EXPECT_THROW((Impedance{*task.arm, Impedance::SetPoint{}}), NonFatalError);

  ImpedanceParameters stiff;
  stiff.stiffness[2] = 3000;  // K / D = 30 / s, 20 ms a step
  EXPECT_THROW(Move({*task.arm}, {}, Impedance{*task.arm, Pose::Identity(), stiff}.until(ElapsedSteps{5})),
               NonFatalError);
  task.arm->set_macrostep(5, 4);
  EXPECT_NO_THROW(Move({*task.arm}, {}, Impedance{*task.arm, Pose::Identity(), stiff}.until(ElapsedSteps{5})));
}

}  // namespace
}  // namespace mrroc::impedance_test
