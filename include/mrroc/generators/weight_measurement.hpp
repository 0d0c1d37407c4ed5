#pragma once

#include <memory>
#include <vector>

#include "mrroc/generator.hpp"
#include "mrroc/load_identification.hpp"
#include "mrroc/robot.hpp"

namespace mrroc {

class JointLeg;

/// Parameters of weighing a load.
struct Weighing {
  double speed = 0.3;      ///< between the postures, as JointLine's, in (0, 1]
  double settling = 0.8;   ///< s of rest before the readings
  double measuring = 0.4;  ///< s over which they are averaged
  LoadIdentification::Offset offset = LoadIdentification::Offset::unknown;
  Eigen::Vector3d gravity = standard_gravity();  ///< in the robot's base frame, m/s^2
};

/// Weighs the load on the wrist's force sensor: moves to each of several postures in turn, rests, averages the wrench
/// that the robot's EDP reports (`RobotState::wrench`), and computes mass and centre of gravity in the tool frame from
/// all averages (`LoadIdentification`). The tool must touch nothing during this.
///
/// The result is the weight of everything that the sensor carries and the deployment does not subtract from its
/// readings: with `tool_mass` in the deployment, of the object that the tool holds; without it, of the tool too. The
/// sensor's zero does not matter unless the offset is assumed to be zero.
///
/// Ends on its own after the last posture; after a pause it continues with the interrupted posture. The robot needs
/// `force_sensor` in the deployment. (The original's `weight_measure`.)
class WeightMeasurement : public Generator {
 public:
  /// Postures: joints, rad or m. Throws NonFatalError (invalid_argument, not_finite, joint_limit).
  WeightMeasurement(Robot& robot, std::vector<JointVector> postures, const Weighing& weighing = {});
  ~WeightMeasurement() override;
  WeightMeasurement(WeightMeasurement&&) noexcept;
  WeightMeasurement& operator=(WeightMeasurement&&) noexcept;

  void start() override;
  void resume() override;
  bool terminal_condition() override;
  void next_state() override;

  /// After the Move. Throws NonFatalError(invalid_argument) when the postures were too few or too similar.
  LoadEstimate estimate() const { return readings_.estimate(); }

 private:
  void read();

  Robot* robot_;
  std::vector<JointVector> postures_;
  Weighing weighing_;
  LoadIdentification readings_;
  std::unique_ptr<JointLeg> leg_;
  std::size_t posture_ = 0;
  double time_ = 0;              // since the leg's start, at the end of the commanded motion
  bool resting_ = false;         // at the posture
  double rest_ = 0;              // s of it
  Tick last_ = 0;                // of the state before
  Wrench sum_ = Wrench::Zero();  // of the readings
  int count_ = 0;
};

}  // namespace mrroc
