#pragma once

#include <memory>
#include <vector>

#include "mrroc/generator.hpp"
#include "mrroc/load_identification.hpp"
#include "mrroc/robot.hpp"

namespace mrroc {

class JointLeg;

/// How a load is weighed.
struct Weighing {
  double speed = 0.3;      ///< of the ways between the postures, as JointLine's, in (0, 1]
  double settling = 0.8;   ///< s of rest before the readings
  double measuring = 0.4;  ///< s over which they are averaged
  LoadIdentification::Offset offset = LoadIdentification::Offset::unknown;
  Eigen::Vector3d gravity = standard_gravity();  ///< in the robot's base frame, m/s^2
};

/// Weighs what hangs on the wrist's force sensor: goes to each of several postures in turn, rests, averages the wrench
/// that the robot's EDP reports (`RobotState::wrench`), and finds mass and centre of gravity in the tool frame from all
/// of them (`LoadIdentification`). Nothing may be touched meanwhile.
///
/// It is the weight of everything that the sensor carries and the deployment does not take out of its readings: with
/// `tool_mass` in the deployment, of what the tool holds; without, of the tool too. The sensor's zero does not matter
/// unless the offset is said to be zero.
///
/// Ends on its own after the last posture; after a pause it continues with the posture that it was at. The robot needs
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

  /// After the Move. Throws NonFatalError(invalid_argument) when the postures were too few or too much alike.
  LoadEstimate estimate() const { return readings_.estimate(); }

 private:
  void read();

  Robot* robot_;
  std::vector<JointVector> postures_;
  Weighing weighing_;
  LoadIdentification readings_;
  std::unique_ptr<JointLeg> leg_;
  std::size_t posture_ = 0;
  double time_ = 0;              // since the leg's start, at the end of what has been commanded
  bool resting_ = false;         // at the posture
  double rest_ = 0;              // s of it
  Tick last_ = 0;                // of the state before
  Wrench sum_ = Wrench::Zero();  // of the readings
  int count_ = 0;
};

}  // namespace mrroc
