#include "cli/robot/import/inertia.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "config/text/message_text.hpp"

namespace mrroc::cli {

namespace {

constexpr double kDensity = 500;                       // kg/m3, of a bounding box
constexpr double kLightest = 2, kHeaviest = 30000;     // kg/m3, of a bounding box
constexpr double kLargestGyration = 1.5;               // radius, of the box's diagonal
constexpr double kSmallBox = 1e-6;                     // m3: below, the density is not judged
constexpr double kBallMass = 0.1, kBallRadius = 0.02;  // kg, m
constexpr double kTriangle = 0.01;                     // relative
constexpr double kSmallestMoment = 1e-10;              // kg m2
constexpr double kSmallestEdge = 1e-3;                 // m, of a box

Eigen::Vector3d moments_of(const UrdfInertial& inertial) {
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(inertial.inertia, Eigen::EigenvaluesOnly).eigenvalues();
}

}  // namespace

std::string inertia_problem(const UrdfInertial& inertial, const Eigen::AlignedBox3d& box) {
  if (!(inertial.mass > 0)) return "the mass " + config::number_text(inertial.mass) + " is not positive";
  const Eigen::Vector3d moments = moments_of(inertial);  // ascending
  if (!(moments[0] > 0)) return "the inertia is not positive definite";
  if (moments[0] + moments[1] < (1 - kTriangle) * moments[2]) return "no body has such an inertia (A + B < C)";
  if (box.isEmpty()) return "";
  const double size = box.diagonal().norm();
  if (std::sqrt(moments[2] / inertial.mass) > kLargestGyration * size)
    return "the inertia is too large for the size of the link";
  const double volume = box.volume();
  if (volume < kSmallBox) return "";
  const double density = inertial.mass / volume;
  if (density < kLightest || density > kHeaviest) return "the mass does not fit the size of the link";
  return "";
}

BodyInertia principal_inertia(const UrdfInertial& inertial) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(inertial.inertia);
  BodyInertia result;
  result.mass = inertial.mass;
  result.moments = solver.eigenvalues();
  const double lack = result.moments[2] - result.moments[0] - result.moments[1];
  // MuJoCo compares without tolerance
  const double least = 1e-12 * result.moments[2];
  if (lack > -least) result.moments.head<2>().array() += lack / 2 + least;
  Eigen::Matrix3d axes = solver.eigenvectors();
  if (axes.determinant() < 0) axes.col(0) = -axes.col(0);
  result.axes = inertial.origin;
  result.axes.linear() = inertial.origin.linear() * axes;
  return result;
}

BodyInertia guessed_inertia(const Eigen::AlignedBox3d& box) {
  BodyInertia result;
  if (box.isEmpty()) {
    result.mass = kBallMass;
    result.moments.setConstant(0.4 * kBallMass * kBallRadius * kBallRadius);
    return result;
  }
  const Eigen::Vector3d edges = box.sizes().cwiseMax(kSmallestEdge);
  const Eigen::Vector3d squares = edges.cwiseAbs2();
  result.mass = kDensity * edges.prod();
  result.moments = (squares.sum() - squares.array()) * result.mass / 12;
  result.moments = result.moments.cwiseMax(kSmallestMoment);
  result.axes.translation() = box.center();
  return result;
}

}  // namespace mrroc::cli
