#pragma once

#include <vector>

#include "geometry/quintic_piece.hpp"
#include "mrroc/types.hpp"

namespace mrroc {

/// A point on a path of the tool, which is a function of a parameter s: its pose and, in base axes, the derivatives by
/// s of the position and the rotation (angular velocity) with their derivatives.
struct PathPose {
  Pose pose = Pose::Identity();
  Twist first = Twist::Zero();
  Twist second = Twist::Zero();
};

/// A path of the tool: pieces, each from one of `breaks` to the next, without a corner inside. Any thread; `at`
/// allocates nothing and never throws.
class PosePath {
 public:
  virtual ~PosePath() = default;
  /// Of the piece's own parameters, from breaks()[piece] to breaks()[piece + 1]; at its ends exactly the given values.
  virtual PathPose at(std::size_t piece, double s) const noexcept = 0;
  /// Where pieces begin and end: 0, ..., the length; ascending. {0}: the path is a point.
  const std::vector<double>& breaks() const noexcept { return breaks_; }

 protected:
  std::vector<double> breaks_{0};
};

/// The smooth path between two poses: a polynomial of degree five for the position p and for the rotation vector phi,
///   R(s) = exp([phi(s)]) R(0),
/// with pose, first and second derivative as given at both ends (src/geometry/rotation_rates.hpp). So pieces that share
/// their ends make a path with continuous velocity and acceleration, linear and angular. Between ends that fit one it
/// is a straight line with rotation about one axis. The rotation from one end to the other is the shorter one, below
/// pi.
class PosePiece {
 public:
  PosePiece(const PathPose& from, const PathPose& to, double length);
  /// s of 0..length.
  PathPose at(double s) const noexcept;

 private:
  using Coordinates = QuinticPiece<6>;
  static Coordinates plan(const PathPose& from, const PathPose& to, double length);

  PathPose from_, to_;
  Coordinates coordinates_;  ///< p, phi
};

/// A path of PosePieces.
class PiecedPath : public PosePath {
 public:
  /// Continues from the last end; both ends are given, so that the path may have corners.
  void add(const PathPose& from, const PathPose& to, double length);
  PathPose at(std::size_t piece, double s) const noexcept override;

 private:
  std::vector<PosePiece> pieces_;
};

/// The straight line between two poses with rotation about one axis, as its two ends; its pace is constant.
struct LineEnds {
  PathPose from, to;
};
LineEnds line_between(const Pose& from, const Pose& to, double length) noexcept;

/// The shortest rotation from one orientation to another, in base axes: a rotation vector.
Eigen::Vector3d turn_between(const Pose& from, const Pose& to) noexcept;

/// Whether they count as one point of a path (src/geometry/near_places.hpp).
bool are_near(const Pose& a, const Pose& b) noexcept;

/// Seconds from one pose to the other at full speed, of the slower of position and orientation.
double full_speed_time(const Pose& from, const Pose& to, double speed, double angular_speed) noexcept;

}  // namespace mrroc
