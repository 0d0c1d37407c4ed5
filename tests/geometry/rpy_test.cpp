#include <gtest/gtest.h>

#include <cstdio>
#include <numbers>
#include <random>

#include "geometry/rigid_motion.hpp"

namespace mrroc {
namespace {

/// Also where the pitch is +-pi/2, and near it.
TEST(Rpy, GivesTheRotationAgain) {
  std::mt19937_64 random(1);
  std::printf("seed 1\n");
  const auto angle = [&] { return std::uniform_real_distribution(-std::numbers::pi, std::numbers::pi)(random); };
  for (int round = 0; round < 20000; ++round) {
    const double side = round % 2 == 0 ? 0.5 : -0.5;
    const double off = std::pow(10, -1 - round % 18);
    const double pitch = round % 3 == 0 ? angle() : side * std::numbers::pi + (round % 3 == 1 ? 0 : off);
    const Eigen::Matrix3d rotation = pose_from_rpy(Eigen::Vector3d::Zero(), {angle(), pitch, angle()}).linear();
    const Eigen::Matrix3d again = pose_from_rpy(Eigen::Vector3d::Zero(), rpy_of(rotation)).linear();
    ASSERT_LT((again - rotation).cwiseAbs().maxCoeff(), 1e-14) << "pitch " << pitch;
  }
}

}  // namespace
}  // namespace mrroc
