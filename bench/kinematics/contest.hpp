#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bench/kinematics/kdl_kinematics.hpp"
#include "bench/kinematics/postures.hpp"

namespace mrroc::bench {

/// Times of one function, ns per call, a value per round.
struct FunctionTimes {
  std::vector<double> own;
  std::vector<double> kdl;  ///< empty where KDL has no chain
};

/// One robot's kinematics against KDL's on the same postures: the robot's first model with its own tool.
class Contest {
 public:
  struct Options {
    int postures = 500;
    double off = 0.05;  ///< of the inverse's start, rad or m per joint
    std::uint64_t seed = 1;
  };

  /// Draws the postures and compares the answers. Throws std::runtime_error when pose or Jacobian differ from KDL's or
  /// the inverse's pose from the one asked for by more than 1e-9, that of KDL's inverse by more than 1e-5 m or 1e-3
  /// rad, or when most postures are refused.
  Contest(RobotModels models, const Options& options);

  /// Measures everything once, in turn, in processor time of this thread. `forwards`: this project's before KDL's.
  void run_round(bool forwards);

  const RobotParameters& parameters() const { return kinematics_.model().parameters(); }
  const std::string& robot() const { return parameters().type; }
  /// Why KDL does not take part; empty: it does.
  const std::string& without_kdl() const { return without_kdl_; }
  /// Postures that were drawn again because an inverse did not find them.
  struct Refused {
    int own = 0;
    int lma = 0;
    int newton = 0;
  };
  const Refused& refused() const { return refused_; }

  FunctionTimes direct, inverse, jacobian;  ///< KDL's inverse is LMA
  std::vector<double> newton;               ///< KDL's other inverse, ns per call

 private:
  bool answer(const Posture& posture);
  void compare(std::size_t i);

  RobotModels models_;
  ToolKinematics kinematics_;
  std::optional<KdlKinematics> kdl_;
  std::string without_kdl_;
  std::vector<Posture> postures_;
  Refused refused_;
};

}  // namespace mrroc::bench
