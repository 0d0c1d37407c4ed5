#include "edp/servo/encoders.hpp"

#include <cmath>
#include <numbers>

namespace mrroc::edp {
namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;
constexpr double kSwitchEdge = 0.5;  // turns from the zero pulse: as far from this one as from the next

}  // namespace

Encoders::Encoders(const RobotParameters& parameters, bool synchronised)
    : count_(parameters.axes.size()), synchronised_(synchronised) {
  for (std::size_t i = 0; i < count_; ++i) {
    const AxisParameters& axis = parameters.axes[i];
    axes_[i] = {kTurn / axis.encoder_increments, axis.motor_synchro, std::copysign(1.0, axis.synchro_coarse),
                axis.motor_min - axis.following_error_max, axis.motor_max + axis.following_error_max};
  }
}

void Encoders::read(const JointVector& shafts, HardwareInput& input) noexcept {
  input.motors.resize(shafts.size());
  input.synchronised = synchronised_;
  for (std::size_t i = 0; i < count_; ++i) {
    Axis& axis = axes_[i];
    const auto k = static_cast<Eigen::Index>(i);
    const double shaft = std::round(shafts[k] / axis.increment) * axis.increment;
    if (!started_) {
      axis.previous = shaft;
      if (!synchronised_) axis.offset = -shaft;
    }
    const double turns = (shaft - axis.synchro) / kTurn, before = (axis.previous - axis.synchro) / kTurn;
    AxisSwitches& switches = input.switches[i];
    switches.synchro = axis.direction * turns >= kSwitchEdge;
    switches.lower_limit = shaft <= axis.lower;
    switches.upper_limit = shaft >= axis.upper;
    switches.zero_pulse = std::floor(turns) != std::floor(before);
    // the whole turn that lies between the two readings, the later one when there are more
    if (switches.zero_pulse)
      switches.zero_position =
          axis.synchro + kTurn * (turns > before ? std::floor(turns) : std::ceil(turns)) + axis.offset;
    axis.previous = shaft;
    input.motors[k] = shaft + axis.offset;
  }
  started_ = true;
}

JointVector Encoders::shafts(const JointVector& motors) const noexcept {
  JointVector shafts = motors;
  for (std::size_t i = 0; i < count_; ++i) shafts[static_cast<Eigen::Index>(i)] -= axes_[i].offset;
  return shafts;
}

void Encoders::set_origin(const JointVector& shift) noexcept {
  for (std::size_t i = 0; i < count_; ++i) axes_[i].offset += shift[static_cast<Eigen::Index>(i)];
  synchronised_ = true;
}

}  // namespace mrroc::edp
