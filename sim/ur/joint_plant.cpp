#include "sim/ur/joint_plant.hpp"

#include <cmath>
#include <numbers>

namespace mrroc::sim::ur {
namespace {

/// A link of Denavit and Hartenberg: turn q about z, d along z, a along x, turn alpha about x.
struct Link {
  double d, a, alpha;
};
/// Those that Universal Robots publishes for the UR5e.
constexpr double kQuarter = std::numbers::pi / 2;
constexpr std::array<Link, 6> kUr5e{{{0.1625, 0, kQuarter},
                                     {0, -0.425, 0},
                                     {0, -0.3922, 0},
                                     {0.1333, 0, kQuarter},
                                     {0.0997, 0, -kQuarter},
                                     {0.0996, 0, 0}}};

}  // namespace

Flange ExactJoints::flange() const {
  using Eigen::AngleAxisd, Eigen::Translation3d, Eigen::Vector3d;
  Flange flange;
  for (std::size_t i = 0; i < kUr5e.size(); ++i)
    flange.pose = flange.pose * AngleAxisd(position_[i], Vector3d::UnitZ()) * Translation3d(kUr5e[i].a, 0, kUr5e[i].d) *
                  AngleAxisd(kUr5e[i].alpha, Vector3d::UnitX());
  flange.load = load_;
  return flange;
}

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
