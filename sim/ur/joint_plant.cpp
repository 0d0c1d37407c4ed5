#include "sim/ur/joint_plant.hpp"

#include <cmath>

namespace mrroc::sim::ur {

void ExactJoints::step(const JointTargets& targets, double period) {
  const double w = bandwidth_, decay = std::exp(-w * period);
  for (std::size_t i = 0; i < position_.size(); ++i) {
    double& x = position_[i];
    double& rate = velocity_[i];
    switch (targets.kind) {
      case JointTargets::Kind::position: {
        const double error = x - targets.position[i], sum = rate + w * error;
        x = targets.position[i] + (error + sum * period) * decay;
        rate = (rate - w * sum * period) * decay;
        break;
      }
      case JointTargets::Kind::velocity: {
        const double lag = rate - targets.velocity[i];
        x += targets.velocity[i] * period + lag * (1 - decay) / w;
        rate = targets.velocity[i] + lag * decay;
        break;
      }
      case JointTargets::Kind::brake:
        rate = 0;
        break;
    }
  }
}

}  // namespace mrroc::sim::ur
