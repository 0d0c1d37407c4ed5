#include "calibration/hand_eye.hpp"

namespace mrroc::calibration {

HandEyePriors arm_priors(double joint, double arm) noexcept {
  HandEyePriors priors;
  priors.joint = joint;
  priors.position = arm;
  priors.rotation = 2 * arm;
  return priors;
}

HandEyePriors whole_arm_priors() noexcept {
  HandEyePriors priors = arm_priors(0.001, 2e-6);
  priors.link_position = priors.link_rotation = 0.0003;
  priors.gear = 0.0002;
  priors.corner = 2e-5;
  return priors;
}

}  // namespace mrroc::calibration
