#pragma once

#include <random>

#include "geometry/rigid_motion.hpp"
#include "mrroc/types.hpp"

namespace mrroc::calibration {

/// Random quantities of one test case, from its seed.
class Seeded {
 public:
  explicit Seeded(std::uint32_t seed) : engine_(seed) {}

  double within(double size) { return std::uniform_real_distribution<double>(-size, size)(engine_); }
  double normal(double deviation) {
    return deviation > 0 ? std::normal_distribution<double>(0, deviation)(engine_) : 0;
  }
  Eigen::Vector3d vector(double size) { return {within(size), within(size), within(size)}; }
  Eigen::Vector3d noise(double deviation) { return {normal(deviation), normal(deviation), normal(deviation)}; }
  Eigen::Matrix3d rotation() { return exp_rotation(vector(2)); }

 private:
  std::mt19937 engine_;
};

}  // namespace mrroc::calibration
