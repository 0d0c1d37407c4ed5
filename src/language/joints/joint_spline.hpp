#pragma once

#include "geometry/quintic_piece.hpp"
#include "language/paths/robot_path.hpp"
#include "mrroc/robot_parameters.hpp"

namespace mrroc {

/// The joints' path through waypoints: a cubic spline over the time that a joint takes from waypoint to waypoint at
/// full speed, of the slowest one. It has continuous first and second derivatives and no curvature at its ends.
///
/// Where the spline, but no waypoint, would exceed a position limit, or come closer to it than a stop needs (a^3 /
/// j^2), the joint's tangents are flattened at the two waypoints: second derivative 0, and first one 0 where the
/// direction reverses, else at most 1.25 times the smaller of the slopes. Then the piece's velocity does not change its
/// sign (its Bernstein coefficients are d0, d0, 5 D - 2 d0 - 2 d1, d1, d1), so it stays between the waypoints.
///
/// If a joint reverses exactly at its limit, the EDP's polynomials between the macrosteps' ends, which replace |t|^3
/// there, would exceed it a little. So an intermediate waypoint is passed at least j T^3 / 192 inside (T: a macrostep;
/// 0.002 mrad for the IRb-6's wrist and 20 ms).
class JointSpline : public RobotPath {
 public:
  /// `waypoints` within the limits; one near the previous one (near_places.hpp) is dropped, the last one never.
  /// `speed`: as in JointLine; `step`: the duration of a macrostep, s.
  JointSpline(const RobotParameters& parameters, const std::vector<JointVector>& waypoints, double speed, double step);

  PathRates rates(std::size_t piece, double s) const noexcept override;
  JointVector joints(double s) const noexcept override;
  void command(double s, double speed, double acceleration, RobotCommand& command) const noexcept override;

 private:
  using Piece = QuinticPiece<Eigen::Dynamic, kMaxJoints>;
  void keep_off_limits(const RobotParameters& parameters, double step);
  void plan();
  void build();
  bool calm(const RobotParameters& parameters);
  bool calm_at(std::size_t knot, Eigen::Index joint);

  std::vector<Piece::State> knots_;
  std::vector<Piece> pieces_;
};

}  // namespace mrroc
