#include "edp/force/force_law.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <limits>

#include "edp/random_values.hpp"

namespace mrroc::edp::force_law_test {
namespace {

Twist any_six(double magnitude) {
  Twist values;
  for (double& value : values) value = number(-magnitude, magnitude);
  return values;
}

ForceLaw any_law() {
  ForceLaw law;
  for (AxisBehaviour& behaviour : law.behaviour) behaviour = static_cast<AxisBehaviour>(*rc::gen::inRange(0, 3));
  law.wrench = any_six(100);
  law.inertia = any_six(50).cwiseAbs();
  law.admittance = any_six(0.2).cwiseAbs() + ForceLaw::Axes::Constant(1e-4);
  return law;
}

// MRROC++ 2012, edp_e_manip.cc: increments per step, and the force that the tool exerts
TEST(ForceLaw, EqualsThatOfTheOriginal) {
  EXPECT_TRUE(rc::check([] {
    const ForceLaw law = any_law();
    const Twist velocity = any_six(0.5), previous = any_six(0.5);
    const Wrench measured = any_six(100);
    const double dt = number(0.0005, 0.02);
    const Twist twist = follow_force(law, velocity, measured, previous, dt);
    for (int i = 0; i < 6; ++i) {
      double b = law.admittance[i], m = law.inertia[i], v = velocity[i], desired = -law.wrench[i];
      switch (law.behaviour[static_cast<std::size_t>(i)]) {
        case AxisBehaviour::unguarded:
          b = m = 0;
          break;
        case AxisBehaviour::guarded:
          desired = 0;
          break;
        case AxisBehaviour::contact:
          v = 0;
          break;
      }
      const double exerted = -measured[i], delta_before = previous[i] * dt;
      const double delta = ((b * (desired - exerted) + v) * dt * dt + b * m * delta_before) / (dt + b * m);
      RC_ASSERT(std::abs(twist[i] - delta / dt) <= 1e-9 * std::max(1.0, std::abs(twist[i])));
    }
  }));
}

TEST(ForceLaw, DefaultLawIsTheOriginalsWithoutGuards) {
  const ForceLaw law;
  for (const AxisBehaviour behaviour : law.behaviour) EXPECT_EQ(behaviour, AxisBehaviour::unguarded);
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(law.inertia[i], 20);
    EXPECT_EQ(law.admittance[i], 0.005);
    EXPECT_EQ(law.inertia[i + 3], 0.5);
    EXPECT_EQ(law.admittance[i + 3], 0.1);
  }
}

TEST(ForceLaw, ForceAgainstASpringSettlesAtTheDesiredOne) {
  EXPECT_TRUE(rc::check([] {
    const double stiffness = number(100, 5000), desired = number(-30, -1), dt = 0.002;
    ForceLaw law;
    law.contact(2, desired);
    law.admittance[2] = 20 / stiffness;                   // 20 / s
    law.inertia[2] = number(0.0, 0.2) * stiffness / 400;  // 4 b^2 k m < 1
    double position = 0, velocity = 0, strongest = 0;
    for (int i = 0; i < 2000; ++i) {
      Wrench measured = Wrench::Zero();
      measured[2] = -stiffness * position;
      Twist previous = Twist::Zero();
      previous[2] = velocity;
      velocity = follow_force(law, Twist::Zero(), measured, previous, dt)[2];
      position += velocity * dt;
      strongest = std::max(strongest, stiffness * position);
    }
    RC_ASSERT(std::abs(stiffness * position + desired) < 1e-6);
    RC_ASSERT(strongest < -desired * 1.01);
  }));
}

TEST(ForceLaw, WrenchInAnotherFrameDoesTheSamePower) {
  EXPECT_TRUE(rc::check([] {
    const Twist place = any_six(1);
    Pose frame = Pose::Identity();
    frame.translation() = place.head<3>();
    frame.linear() = Eigen::AngleAxisd(place.tail<3>().norm(), place.tail<3>().stableNormalized()).toRotationMatrix();
    const Wrench wrench = any_six(50);
    const Twist twist = any_six(1);
    Twist there;  // of the frame's origin, in its axes
    there << frame.linear().transpose() * (twist.head<3>() + twist.tail<3>().cross(frame.translation())),
        frame.linear().transpose() * twist.tail<3>();
    RC_ASSERT(std::abs(seen_from(frame, wrench).dot(there) - wrench.dot(twist)) < 1e-9);
  }));
}

TEST(ForceLaw, RefusesInvalidLawsWithTheirAxis) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto code = [](ForceLaw law, const Twist& velocity = Twist::Zero()) {
    const ErrorReport report = check_force_law(law, velocity);
    if (report.code != ErrorCode::none) {
      EXPECT_NE(report.detail.view().find("axis 3"), std::string_view::npos);
    }
    return report.code;
  };
  ForceLaw law;
  law.contact(2, -10).guarded(0);
  EXPECT_EQ(code(law), ErrorCode::none);
  Twist velocity = Twist::Zero();
  velocity[2] = nan;
  EXPECT_EQ(code(law, velocity), ErrorCode::not_finite);
  ForceLaw wrong = law;
  wrong.wrench[2] = nan;
  EXPECT_EQ(code(wrong), ErrorCode::not_finite);
  wrong = law;
  wrong.inertia[2] = -1;
  EXPECT_EQ(code(wrong), ErrorCode::invalid_argument);
  wrong = law;
  wrong.admittance[2] = 0;
  EXPECT_EQ(code(wrong), ErrorCode::invalid_argument) << "a contact axis that cannot move";
  wrong.guarded(2);
  EXPECT_EQ(code(wrong), ErrorCode::none);
  wrong.behaviour[2] = static_cast<AxisBehaviour>(3);
  EXPECT_EQ(code(wrong), ErrorCode::invalid_argument);
}

}  // namespace
}  // namespace mrroc::edp::force_law_test
