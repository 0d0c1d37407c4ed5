#pragma once

#include <array>
#include <optional>

#include "mrroc/signals.hpp"
#include "mrroc/types.hpp"

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

/// The flange of the arm and the load on it.
struct Flange {
  Pose pose = Pose::Identity();  ///< in the base frame
  Wrench load = Wrench::Zero();  ///< of the environment and of the payload: N, N m, in its axes, about its origin
};

/// The arm below a simulated UR controller, and what is wired to the controller's terminals.
class JointPlant {
 public:
  virtual ~JointPlant() = default;
  /// Measures the joints now; `step` measures them, too.
  virtual void measure() {}
  /// One period of the controller with these targets.
  virtual void step(const JointTargets& targets, double period) = 0;
  virtual Six position() const = 0;  ///< rad
  virtual Six velocity() const = 0;  ///< rad/s
  virtual Flange flange() const = 0;

  /// The controller's inputs: digital 0 to 15, analogue 0 to 3. Nothing: nothing is wired to them.
  virtual std::optional<ControllerIo> inputs() const { return {}; }
  virtual void set_outputs(const ControllerIo& /*outputs*/) {}
};

/// Six joints without masses. With w the bandwidth (rad/s), x the position, r and v the targets:
///
///   position: x'' = w^2 (r - x) - 2 w x',   velocity: x'' = w (v - x'),   brake: x' = 0,
///
/// solved exactly for targets that are constant during a period. The flange is that of a UR5e, with a constant load.
/// Deterministic.
class ExactJoints : public JointPlant {
 public:
  explicit ExactJoints(const Six& position, double bandwidth = 60) : position_(position), bandwidth_(bandwidth) {}

  void step(const JointTargets& targets, double period) override;
  Six position() const override { return position_; }
  Six velocity() const override { return velocity_; }
  Flange flange() const override;
  void set_load(const Wrench& load) noexcept { load_ = load; }

 private:
  Six position_{}, velocity_{};
  double bandwidth_;
  Wrench load_ = Wrench::Zero();
};

}  // namespace mrroc::sim::ur
