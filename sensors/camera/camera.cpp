#include "mrroc/sensors/camera.hpp"

#include <array>
#include <cstdio>

#include "mrroc/errors.hpp"

namespace mrroc {

namespace {

std::string condition_name(const Camera& camera, double metres) {
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), " sees it within %g m", metres);
  return camera.name() + text.data();
}

}  // namespace

Camera::Camera(Task& task, const std::string& name) : Sensor(task, name, "camera") {}

Eigen::Vector3d Camera::position() const noexcept { return {seen(1), seen(2), seen(3)}; }

Eigen::Vector3d Camera::position_deviation() const noexcept { return {seen(8), seen(9), seen(10)}; }

Pose Camera::pose() const noexcept {
  Pose pose = Pose::Identity();
  pose.translation() = position();
  pose.linear() = Eigen::Quaterniond{seen(4), seen(5), seen(6), seen(7)}.toRotationMatrix();
  return pose;
}

Seen::Seen(const Camera& camera) : Condition(camera.name() + " sees it"), camera_(&camera) {}

Seen::Seen(const Camera& camera, double metres)
    : Condition(condition_name(camera, metres)), camera_(&camera), metres_(metres) {
  if (!(metres > 0)) {
    throw NonFatalError(ErrorCode::invalid_argument,
                        "Seen within " + std::to_string(metres) + " m, expected a deviation above 0");
  }
}

bool Seen::holds() { return camera_->detected() && camera_->position_deviation().maxCoeff() <= metres_; }

}  // namespace mrroc
