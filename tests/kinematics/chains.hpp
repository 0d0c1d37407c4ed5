#pragma once

#include <array>
#include <numbers>
#include <random>
#include <vector>

#include "kinematics/serial_chain.hpp"

/// Chains for tests, with their makers' published Denavit-Hartenberg parameters where there is such an arm.
namespace mrroc::kinematics::test {

/// Rz(q + offset) Tz(d) Tx(a) Rx(alpha).
struct DhRow {
  double d, a, alpha, offset = 0;
};

inline SerialChain chain_of(const std::vector<DhRow>& rows) {
  std::vector<ChainJoint> joints;
  Pose frame = Pose::Identity();
  for (const DhRow& row : rows) {
    joints.push_back(
        {frame * Eigen::AngleAxisd(row.offset, Eigen::Vector3d::UnitZ()), Eigen::Vector3d::UnitZ(), false});
    frame = Eigen::Translation3d(row.a, 0, row.d) * Eigen::AngleAxisd(row.alpha, Eigen::Vector3d::UnitX());
  }
  return {joints, frame};
}

inline constexpr double kRight = std::numbers::pi / 2;

inline SerialChain ur5e() {
  return chain_of({{0.1625, 0, kRight},
                   {0, -0.425, 0},
                   {0, -0.3922, 0},
                   {0.1333, 0, kRight},
                   {0.0997, 0, -kRight},
                   {0.0996, 0, 0}});
}
inline SerialChain puma560() {
  return chain_of(
      {{0, 0, kRight}, {0, 0.4318, 0}, {0.15005, 0.0203, -kRight}, {0.4318, 0, kRight}, {0, 0, -kRight}, {0, 0, 0}});
}
inline SerialChain irb140() {
  return chain_of({{0.352, 0.07, -kRight},
                   {0, 0.36, 0, -kRight},
                   {0, 0, -kRight},
                   {0.38, 0, kRight},
                   {0, 0, -kRight},
                   {0.065, 0, 0}});
}
inline SerialChain panda() {
  return chain_of({{0.333, 0, -kRight},
                   {0, 0, kRight},
                   {0.316, 0.0825, kRight},
                   {0, -0.0825, -kRight},
                   {0.384, 0, kRight},
                   {0, 0.088, kRight},
                   {0.107, 0, 0}});
}

inline JointVector random_joints(std::mt19937_64& random, int count) {
  JointVector joints(count);
  for (double& joint : joints) joint = std::uniform_real_distribution(-std::numbers::pi, std::numbers::pi)(random);
  return joints;
}

inline Eigen::Vector3d random_vector(std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  return {normal(random), normal(random), normal(random)};
}

inline Pose random_pose(std::mt19937_64& random) {
  const Eigen::Vector3d axis = random_vector(random).normalized();
  return Eigen::Translation3d(0.3 * random_vector(random)) *
         Eigen::AngleAxisd(std::uniform_real_distribution(-3.0, 3.0)(random), axis);
}

inline SerialChain random_chain(std::mt19937_64& random, int count, bool slides) {
  std::vector<ChainJoint> joints;
  for (int i = 0; i < count; ++i)
    joints.push_back({random_pose(random), random_vector(random).normalized(), slides && random() % 3 == 0});
  return {joints, random_pose(random)};
}

/// A random arm whose axes 4, 5, 6 meet, and whose joints before them are related as `structure` says: through points
/// of axes at zero.
inline SerialChain random_wrist_arm(std::mt19937_64& random, bool parallel12, bool parallel23, bool meet12,
                                    bool meet23) {
  std::array<Eigen::Vector3d, 6> axis, origin;
  for (std::size_t i = 0; i < 6; ++i) {
    axis[i] = random_vector(random).normalized();
    origin[i] = 0.4 * random_vector(random);
  }
  if (parallel12) axis[1] = axis[0];
  if (parallel23) axis[2] = random() % 2 == 0 ? axis[1] : Eigen::Vector3d(-axis[1]);
  if (meet12) origin[1] = origin[0] + 0.3 * axis[0];
  if (meet23) origin[2] = origin[1] + 0.3 * axis[1];
  origin[4] = origin[3] + 0.1 * axis[3];
  origin[5] = origin[4];
  origin[3] = origin[4] - 0.2 * axis[3];
  std::vector<ChainJoint> joints;
  Eigen::Vector3d before = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < 6; ++i) {
    joints.push_back({Pose(Eigen::Translation3d(origin[i] - before)), axis[i], false});
    before = origin[i];
  }
  return {joints, random_pose(random)};
}

}  // namespace mrroc::kinematics::test
