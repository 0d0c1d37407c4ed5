#include <cstdio>
#include <mrroc/ecp.hpp>
#include <mrroc/generators/guarded_approach.hpp>
#include <mrroc/generators/image_servo.hpp>
#include <mrroc/generators/position_servo.hpp>
#include <mrroc/robots/irb6.hpp>
#include <mrroc/sensors/camera.hpp>
#include <mrroc/sensors/infrared.hpp>

using namespace mrroc;

/// Brings a gauge square before a plate of unknown pose, 150 mm from a spot beside the plate's marker: by the
/// marker's pose until it is near, by its corners in the picture until it is exact, then along the gauge's own beam.
class Inspect : public ecp::Task {
  Irb6 arm{*this};
  Camera eye{*this, "eye"};
  Infrared gauge{*this, "gauge"};

  static constexpr double kGauge = 0.28, kHalf = 0.045;  // m: the gauge before the flange, half of the marker
  const Pose camera =
      Eigen::Translation3d(0.08, 0, 0.06 - kGauge) * Eigen::AngleAxisd(M_PI_2, Eigen::Vector3d::UnitZ());

  /// The goal pose of the marker relative to the tool: 60 mm beside the beam, `distance` m ahead, facing the tool.
  static Pose marker_at(double distance) {
    return Eigen::Translation3d(0.06, 0, distance) * Pose(Eigen::AngleAxisd(M_PI, Eigen::Vector3d::UnitX()));
  }

  /// The marker's corners in the picture when it has this pose in the camera frame.
  static ImagePoints corners(const Pose& marker) {
    ImagePoints points(2, 4);
    for (int i = 0; i < 4; ++i)
      points.col(i) = (marker * Eigen::Vector3d(i < 2 ? kHalf : -kHalf, i % 2 ? kHalf : -kHalf, 0)).hnormalized();
    return points;
  }

  std::optional<Pose> marker() const { return eye.detected() ? std::optional(eye.pose()) : std::nullopt; }
  std::optional<ImagePoints> seen() const { return eye.detected() ? std::optional(corners(eye.pose())) : std::nullopt; }
  std::optional<double> range() const { return gauge.detected() ? std::optional(gauge.distance()) : std::nullopt; }

  void run() override {
    arm.set_tool(Pose(Eigen::Translation3d(0, 0, kGauge)));
    arm.set_macrostep(20, 18);  // a picture every 40 ms
    Move({arm}, {}, JointLine{arm, Irb6::tool_down(0.75, 0, 0)});
    Wait({arm}, {eye}, Seen{eye, 0.002} || ElapsedSteps{25}).require<Seen>("there is no plate");

    Move({arm}, {eye},
         PositionServo{arm, [this] { return marker(); }, PositionServo::In::camera, marker_at(0.3), camera});
    const Pose wanted = camera.inverse() * marker_at(0.2);
    Move({arm}, {eye},
         ImageServo{arm,
                    [this] { return seen(); },
                    corners(wanted),
                    ImageDepths::Constant(1, 4, wanted.translation().z()),
                    camera,
                    {},
                    3e-4});
    Move({arm}, {gauge}, GuardedApproach{arm, [this] { return range(); }, {0, 0, 1}, 0.03, 0.15});
    Wait({arm}, {gauge}, ElapsedSteps{10});
    std::printf("the gauge is %.2f mm before the plate\n", 1000 * gauge.distance());
    Move({arm}, {}, ToolVelocity{arm, {0, 0, -0.1}}.until(Travelled{arm, 0.1}));
    Move({arm}, {}, JointLine{arm, arm.parameters().home});
  }
};

MRROC_ECP(Inspect)
