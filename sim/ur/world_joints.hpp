#pragma once

#include "mrroc/robot_parameters.hpp"
#include "mrroc/types.hpp"
#include "sim/ur/joint_plant.hpp"
#include "world/world_memory.hpp"

namespace mrroc::sim::ur {

/// The six joints of a robot in the simulated world, which follow set-points as `sim::JointServo` does. A target of
/// positions moves between two periods with the difference of the last two.
///
/// Each step takes the newest measurement and drives its tick. In real time the controller and the world have periods
/// of their own, so the world's ticks may not be shorter than the controller's periods: the world would wait for each
/// drive.
///
/// The flange is that of `sim::FlangeSensor` where the world measures it, else unloaded at the base; the terminals are
/// those of `sim::ControllerWiring`.
class WorldJoints : public JointPlant {
 public:
  /// Robot slot `slot` of `memory`, whose first measurement is there; `memory` must outlive this object. Throws
  /// SystemError(configuration): the robot does not have six axes, or the file of its drives states no bandwidth.
  WorldJoints(const RobotParameters& robot, world::WorldMemory& memory, std::size_t slot);

  void measure() override;
  void step(const JointTargets& targets, double period) override;
  Six position() const override { return position_; }
  Six velocity() const override { return velocity_; }
  Flange flange() const override { return flange_; }
  std::optional<ControllerIo> inputs() const override { return inputs_; }
  void set_outputs(const ControllerIo& outputs) override { outputs_ = outputs; }

 private:
  const RobotParameters robot_;
  world::WorldMemory& memory_;
  std::size_t slot_;
  Tick tick_ = 0;  ///< of the newest measurement
  Six position_{}, velocity_{};
  Flange flange_;
  ControllerIo inputs_, outputs_;
  JointTargets last_;
};

}  // namespace mrroc::sim::ur
