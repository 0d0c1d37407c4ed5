#include "robots/serial_parallel/wrist.hpp"

#include <cmath>
#include <numbers>

namespace mrroc::serial_parallel {
namespace {

using Eigen::Vector3d;
using std::numbers::pi;

constexpr double kSingular = 1e-10;  // sin(bend)

Vector3d nearest_turns(const Vector3d& angles, const Vector3d& near) {
  return near + (angles - near).unaryExpr([](double change) { return std::remainder(change, 2 * pi); });
}

}  // namespace

Eigen::Matrix3d wrist_rotation(const Vector3d& angles) noexcept {
  return (Eigen::AngleAxisd(angles[0], Vector3d::UnitZ()) * Eigen::AngleAxisd(angles[1], Vector3d::UnitY()) *
          Eigen::AngleAxisd(angles[2], Vector3d::UnitZ()))
      .toRotationMatrix();
}

ErrorCode wrist_angles(const Eigen::Matrix3d& rotation, const Vector3d& near, Vector3d& angles) noexcept {
  const Vector3d axis = rotation.col(2);  // (cos turn sin bend, sin turn sin bend, cos bend)
  const double sine = std::hypot(axis.x(), axis.y());
  if (sine < kSingular) {
    // straight: R = Rz(turn + roll); folded back: R = Rz(turn - roll) Ry(pi)
    const double way = axis.z() > 0 ? 1 : -1;
    const double sum = std::atan2(way * rotation(1, 0), way * rotation(0, 0));
    angles = nearest_turns({near[0], way > 0 ? 0 : pi, way * (sum - near[0])}, near);
    return ErrorCode::singular;
  }
  const Vector3d bent(std::atan2(axis.y(), axis.x()), std::atan2(sine, axis.z()),
                      std::atan2(rotation(2, 1), -rotation(2, 0)));
  const Vector3d first = nearest_turns(bent, near);
  const Vector3d second = nearest_turns({bent[0] + pi, -bent[1], bent[2] + pi}, near);
  angles = (first - near).lpNorm<1>() <= (second - near).lpNorm<1>() ? first : second;
  return ErrorCode::none;
}

}  // namespace mrroc::serial_parallel
