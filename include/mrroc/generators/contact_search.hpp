#pragma once

#include <optional>
#include <vector>

#include "mrroc/generator.hpp"
#include "mrroc/load.hpp"
#include "mrroc/robot.hpp"

namespace mrroc {

/// One probe for contact: from a point along a direction, for a maximum distance. In the robot's base frame.
struct Probe {
  Eigen::Vector3d start = Eigen::Vector3d::Zero();       ///< m
  Eigen::Vector3d direction = Eigen::Vector3d::UnitZ();  ///< of any nonzero length
  double distance = 0;                                   ///< m
};

/// Probes along the z axis of `frame` (base frame) from the crossings of a grid in its x-y plane that begins at its
/// origin: `columns` along x, `spacing` m apart, in `rows` along y, row by row, every other one backwards. Throws
/// NonFatalError(invalid_argument).
std::vector<Probe> grid_of_probes(const Pose& frame, int columns, int rows, double spacing, double distance);

/// Parameters of a search for contact.
struct Probing {
  double speed = 0.005;        ///< m/s, along a probe
  double force = 3;            ///< N at which contact is detected and measured
  double travel_speed = 0.05;  ///< m/s, between the probes
  double acceleration = 0.1;   ///< m/s^2
  bool first_only = false;     ///< end at the first contact, with the tool at rest there
  Load load{};                 ///< on the tool, in the tool frame: its weight is not contact
  Eigen::Vector3d gravity = standard_gravity();
};

/// Searches for contact by several probes, one after the other. For each probe the tool moves straight to its start,
/// then along its direction until it presses with the contact force or has covered the distance, settles at that force,
/// and returns to the start. The contact point is the measured position of the tool frame's origin during the press: on
/// a surface of stiffness k it always lies force / k inside. The tool keeps its orientation.
///
/// Along a probe the tool's axes are guarded as in `GuardedMotion`, so it must be a tip that touches with its tool
/// frame's origin. Between the probes, too, the tool gives way to force, and NonFatalError(force_limit) is thrown when
/// the force is more than twice the contact force.
///
/// Ends on its own after the last probe, at rest at its start; with `first_only` at the first contact. After a pause it
/// continues with the interrupted probe. The robot needs `force_sensor` in the deployment; bias the sensor first.
class ContactSearch : public Generator {
 public:
  /// Throws NonFatalError(invalid_argument) without a probe, or for numbers that are not finite and above 0.
  ContactSearch(Robot& robot, std::vector<Probe> probes, const Probing& probing = {});

  void start() override;
  void resume() override;
  bool terminal_condition() override { return phase_ == Phase::over; }
  void next_state() override;

  /// For each probe its contact point, base frame; empty where it has not touched (yet).
  const std::vector<std::optional<Eigen::Vector3d>>& touched() const noexcept { return touched_; }
  /// Number of contacts so far.
  int count() const noexcept;

 private:
  enum class Phase : std::uint8_t { out, along, pressing, back, over };

  const Probe& probe() const { return probes_[probe_]; }
  void enter(Phase phase) noexcept;
  void travel(const Eigen::Vector3d& to);
  void update();
  void command(const Eigen::Vector3d& velocity);

  Robot* robot_;
  std::vector<Probe> probes_;
  Probing probing_;
  std::vector<std::optional<Eigen::Vector3d>> touched_;
  std::size_t probe_ = 0;
  Phase phase_ = Phase::out;
  int steps_ = 0;  ///< of the phase
  Eigen::Matrix3d orientation_ = Eigen::Matrix3d::Identity();
  Eigen::Vector3d velocity_ = Eigen::Vector3d::Zero();  ///< as commanded last, base axes
  int settled_ = 0;                                     ///< consecutive steps that press with the contact force
};

}  // namespace mrroc
