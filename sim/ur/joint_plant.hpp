#pragma once

#include <array>

namespace mrroc::sim::ur {

using Six = std::array<double, 6>;

/// The targets of the six joints for one period.
struct JointTargets {
  enum class Kind {
    position,  ///< follow `position`
    velocity,  ///< follow `velocity`
    brake      ///< the brakes hold
  };
  Kind kind = Kind::brake;
  Six position{};  ///< rad
  Six velocity{};  ///< rad/s
};

/// The arm below a simulated UR controller.
class JointPlant {
 public:
  virtual ~JointPlant() = default;
  /// One period of the controller with these targets.
  virtual void step(const JointTargets& targets, double period) = 0;
  virtual Six position() const = 0;  ///< rad
  virtual Six velocity() const = 0;  ///< rad/s
};

/// Six joints without masses. With w the bandwidth (rad/s), x the position, r and v the targets:
///
///   position: x'' = w^2 (r - x) - 2 w x',   velocity: x'' = w (v - x'),   brake: x' = 0,
///
/// solved exactly for targets that are constant during a period. Deterministic.
class ExactJoints : public JointPlant {
 public:
  explicit ExactJoints(const Six& position, double bandwidth = 60) : position_(position), bandwidth_(bandwidth) {}

  void step(const JointTargets& targets, double period) override;
  Six position() const override { return position_; }
  Six velocity() const override { return velocity_; }

 private:
  Six position_{}, velocity_{};
  double bandwidth_;
};

}  // namespace mrroc::sim::ur
