#pragma once

#include <array>
#include <string_view>

#include "kinematics/serial_chain.hpp"
#include "kinematics/subproblems.hpp"

namespace mrroc::kinematics {

/// A structure of six turning axes that has an inverse in closed form.
enum class Structure {
  none,
  wrist_after_parallel,        ///< axes 4, 5, 6 meet in a point; 2 and 3 are parallel: most industrial arms
  wrist_after_parallel_base,   ///< axes 4, 5, 6 meet; 1 and 2 are parallel
  wrist_after_crossing_base,   ///< axes 4, 5, 6 meet; 1 and 2 meet
  wrist_after_crossing_elbow,  ///< axes 4, 5, 6 meet; 2 and 3 meet
  three_parallel               ///< axes 2, 3, 4 are parallel, 5 and 6 meet: UR and similar arms
};
std::string_view name_of(Structure structure) noexcept;

/// All postures of six turning axes for a flange pose, in closed form by subproblems (Elias and Wen, 2022). Geometry
/// that is parallel or meeting within a tolerance counts as such; each posture is then improved by Newton's method on
/// the chain itself. With a large tolerance it is the closed form of a similar arm, and finds most postures of an arm
/// that has none. Any thread; allocates nothing, never throws.
class ClosedForm {
 public:
  static constexpr double kTolerance = 1e-4;  ///< rad, m
  static constexpr double kSimilar = 0.3;     ///< m, between axes that meet in a similar arm
  static constexpr std::size_t kMaxPostures = 8;

  struct Postures {
    std::array<JointVector, kMaxPostures> joints;
    std::size_t count = 0;
    bool singular = false;  ///< a joint is free there; it has its value of `near`
  };

  /// The chain is copied. `distance`: m, between axes that count as meeting.
  explicit ClosedForm(const SerialChain& chain, double distance = kTolerance);
  Structure structure() const noexcept { return structure_; }
  explicit operator bool() const noexcept { return structure_ != Structure::none; }

  /// The postures whose flange is at `flange` within `tolerance` (m and rad), angles in (-pi, pi].
  void solve(const Pose& flange, const JointVector& near, double tolerance, Postures& postures) const noexcept;

 private:
  /// Base rotation and wrist of a target, in the zero posture's frames.
  struct Target {
    Eigen::Matrix3d rotation;  ///< R(h1, q1) ... R(h6, q6)
    Eigen::Vector3d reach;     ///< from a point on axis 1 to the centre of the wrist
  };
  struct Search;

  Structure recognise(double tolerance);
  void solve_wrist(Search& search, double q1, double q2, double q3) const noexcept;
  void solve_arm(Search& search) const noexcept;
  void solve_three_parallel(Search& search) const noexcept;
  void solve_planar(Search& search, double q1, double q5, double sum, double q6) const noexcept;
  void add(Search& search, const std::array<double, 6>& joints) const noexcept;

  SerialChain chain_;
  int steps_;                             ///< of Newton's method
  std::array<Eigen::Vector3d, 6> h_, o_;  ///< axes, and points on them, at zero
  Eigen::Matrix3d flange_rotation_;       ///< at zero
  Eigen::Vector3d flange_offset_;         ///< from the centre of the wrist to the flange, at zero
  Structure structure_ = Structure::none;
};

}  // namespace mrroc::kinematics
