#pragma once

#include <cstdint>
#include <random>

#include "mrroc/tool_kinematics.hpp"

namespace mrroc::bench {

/// One question to the contestants.
struct Posture {
  JointVector joints;  ///< within joint and motor limits
  Pose pose;           ///< tool frame in the base frame
  JointVector near;    ///< the joints, each off by the same distance in either direction: the start of the inverse
};

/// Random postures of one robot, evenly distributed within joint and motor limits (-pi to pi where a joint has none).
/// The same seed gives the same postures on every machine with the same standard library.
class Postures {
 public:
  /// `off`: of `near`, rad or m per joint.
  Postures(const ToolKinematics& kinematics, double off, std::uint64_t seed)
      : kinematics_(kinematics), off_(off), random_(seed) {}

  Posture next();

 private:
  JointVector draw_joints();

  const ToolKinematics& kinematics_;
  double off_;
  std::mt19937_64 random_;
};

}  // namespace mrroc::bench
