#include <gtest/gtest.h>

#include <numbers>

#include "cli/ros2/cameras/camera_publisher.hpp"

namespace mrroc::cli::camera_info_test {
namespace {

TEST(CameraInfo, APointIsSeenWhereTheProjectionHasIt) {
  const auto camera = vsp::Intrinsics::pinhole(320, 200, std::numbers::pi / 2);
  const auto info = camera_info(camera);
  EXPECT_EQ(info.width, 320u);
  EXPECT_EQ(info.height, 200u);
  EXPECT_NEAR(info.k[0], 100, 1e-9) << "half of the height is seen under 45 degrees";
  const Eigen::Vector3d point(0.3, -0.2, 2);
  const Eigen::Map<const Eigen::Matrix<double, 3, 4, Eigen::RowMajor>> projection(info.p.data());
  const Eigen::Vector3d seen = projection * point.homogeneous();
  EXPECT_TRUE((seen.head<2>() / seen.z()).isApprox(camera.project(point)));
  EXPECT_EQ(info.d, std::vector<double>(5));
  EXPECT_EQ(info.distortion_model, "plumb_bob");
}

}  // namespace
}  // namespace mrroc::cli::camera_info_test
