#pragma once

#include <gtest/gtest.h>

#include <array>

#include "edp/force/force_rig.hpp"

namespace mrroc::edp {

inline constexpr CommonStop kStop{200, 0, 7};

/// Two robots of one computer, in step.
struct Pair {
  explicit Pair(bool second_first = false) : order_{second_first ? &b : &a, second_first ? &a : &b} {
    a.servo.use_group_stops(stops, 0);
    b.servo.use_group_stops(stops, 1);
  }

  void run(int ticks) {
    for (int i = 0; i < ticks; ++i) {
      order_[0]->tick();
      order_[1]->tick();
    }
  }
  /// Both begin a macrostep of 100 ticks that ends in motion.
  void move(const JointVector& velocity, const CommonStop& stop = kStop) {
    for (GantryBeforeWall* rig : {&a, &b}) ASSERT_FALSE(rig->send(command(*rig, velocity, stop)));
  }
  static RobotCommand command(const GantryBeforeWall& rig, const JointVector& velocity, const CommonStop& stop) {
    const double way = rig.seen().end.at_rest() ? 0.1 : 0.2;
    RobotCommand command = joint_command(rig.seen().end.position + way * velocity, 100, 100);
    command.joint_velocity = velocity;
    command.joint_acceleration = JointVector::Zero(velocity.size());
    command.stop = stop;
    return command;
  }

  clock::GroupStops stops;
  GantryBeforeWall a, b;

 private:
  std::array<GantryBeforeWall*, 2> order_;
};

inline JointVector velocity_of(double x, double y, double z, double yaw) {
  return (JointVector(4) << x, y, z, yaw).finished();
}

inline const JointVector kVelocity = velocity_of(-0.1, 0.2, 0.05, 0.1);

using Break = void (*)(Pair&);
inline void drive_fault(Pair& pair) { pair.a.hardware.fault = ErrorCode::drive_fault; }
inline void drives_lost(Pair& pair) { pair.a.hardware.positions_lost = true; }
inline void emergency_stop(Pair& pair) { pair.a.operators.press(); }
inline void switched_off(Pair& pair) { pair.a.effector.enable(false); }
inline void force_limit(Pair& pair) { pair.a.sensor.extra[1] = 200; }
inline void blind_sensor(Pair& pair) { pair.a.sensor.error = ErrorCode::hardware_silent; }

}  // namespace mrroc::edp
