#include <cmath>
#include <numbers>

#include "robots/irb6/irb6_model.hpp"
#include "sensors/camera/seen_world.hpp"

namespace mrroc::vsp::eye_in_hand_test {
namespace {

const Pose kBase = pose_from_rpy({0.1, -0.2, 0.7}, {0, 0, 0.5});

config::RobotEntry arm_entry() {
  config::RobotEntry arm;
  arm.name = "arm";
  arm.type = "irb6";
  arm.driver.world = true;
  arm.base = kBase;
  return arm;
}

/// Beside the flange, directed along the tool.
const std::string kMount =
    "position = [0.08, 0.0, 0.06]\nrotation = [0.0, 0.0, 1.5707963267948966]\nfield_of_view = 0.8\n";
const std::string kBlob = kMount + "plane = [0.0, 0.0, -0.696]\n";  // in the base frame, which is 0.7 m up

/// An IRb-6 over the table with a camera from a deployment; e_l is the value that its EDP would report.
class Hand {
 public:
  explicit Hand(const std::string& object, const std::string& keys)
      : world_(scene_of(object, marker_assets()), keys, "arm", {arm_entry()}), models_(load_irb6()) {
    world_.open();
  }

  /// Joints of the posture whose tool points down at (x, y), with the camera rotated about it and tilted.
  SensorReading look_from(const JointVector& joints, Tick tick) {
    const RobotModel& model = *models_.front();
    for (std::size_t i = 0; i < model.parameters().axes.size(); ++i) {
      world_.turn("arm/" + model.parameters().axes[i].name, joints[static_cast<Eigen::Index>(i)]);
    }
    RobotState e;
    e.tick = tick;
    e.synchronised = true;
    e.tool = pose_from_rpy({0.01, 0.02, 0.3}, {0.1, 0.2, 0.3});  // the camera does not move with the tool in use
    e.pose = model.flange(joints) * e.tool;
    world_.sensor().effector_state(e);
    return world_.measure(tick);
  }
  /// Pose of the camera in the base frame.
  Pose eye(const JointVector& joints) const {
    return models_.front()->flange(joints) * pose_from_rpy({0.08, 0, 0.06}, {0, 0, std::numbers::pi / 2});
  }
  JointVector home() const { return models_.front()->parameters().home; }
  SeenWorld& world() { return world_; }

 private:
  SeenWorld world_;
  RobotModels models_;
};

/// A part near the tool of the home posture, measured in the robot's base frame.
struct Placement {
  Pose in_base;
  Pose in_world;
  JointVector joints;
};

Placement any_placement(Draw& draw, const JointVector& home, double height) {
  Placement placement;
  placement.joints = home;
  for (int i = 0; i < 6; ++i) placement.joints[i] += draw(-0.06, 0.06);
  placement.joints[5] += draw(-0.5, 0.5);
  placement.in_base = pose_from_rpy({0.80 + draw(-0.05, 0.05), draw(-0.05, 0.05), height - kBase.translation().z()},
                                    {0, 0, draw(-1.5, 1.5)});
  placement.in_world = kBase * placement.in_base;
  return placement;
}

TEST(EyeInHand, BlobIsWithinTwoMillimetresFromFiftyPostures) {
  Hand hand(kPart, kBlob);
  Draw draw(21);
  double worst = 0;
  for (Tick tick = 1; tick <= 50; ++tick) {
    const Placement placement = any_placement(draw, hand.home(), 0.004);
    hand.world().place("part", placement.in_world);
    const SensorReading v = hand.look_from(placement.joints, tick);
    ASSERT_TRUE(detected(v)) << tick;
    worst = std::max(worst, (position_of(v) - placement.in_base.translation()).norm());
  }
  std::printf("worst %.2f mm\n", 1e3 * worst);
  EXPECT_LT(worst, 0.002);
}

TEST(EyeInHand, MarkerIsWithinTwoMillimetresAndOneDegreeFromFiftyPostures) {
  Hand hand(kMarker, kMount + "detect = 'marker'\nmarker = 7\nmarker_size = 0.06\nwidth = 1280\nheight = 960\n");
  Draw draw(22);
  double worst = 0, worst_angle = 0;
  for (Tick tick = 1; tick <= 50; ++tick) {
    const JointVector joints = any_placement(draw, hand.home(), 0).joints;
    const Pose before_the_eye =
        pose_from_rpy({draw(-0.08, 0.08), draw(-0.06, 0.06), draw(0.4, 0.5)}, {std::numbers::pi, 0, 0});
    const Pose marker =
        hand.eye(joints) * before_the_eye * pose_from_rpy({0, 0, 0}, {draw(-0.4, 0.4), draw(-0.4, 0.4), draw(-3, 3)});
    hand.world().place("marker", kBase * marker);
    const SensorReading v = hand.look_from(joints, tick);
    ASSERT_TRUE(detected(v)) << tick;
    worst = std::max(worst, (position_of(v) - marker.translation()).norm());
    worst_angle = std::max(worst_angle, orientation_of(v).angularDistance(Eigen::Quaterniond(marker.linear())));
  }
  std::printf("worst %.2f mm, %.2f deg\n", 1e3 * worst, worst_angle * 180 / std::numbers::pi);
  EXPECT_LT(worst, 0.002);
  EXPECT_LT(worst_angle, std::numbers::pi / 180);
}

TEST(EyeInHand, ReadingIsNotReadyWithoutAKnownPoseOfTheRobot) {
  Hand hand(kPart, kBlob);
  const SensorReading before = hand.world().measure(1);
  EXPECT_EQ(before.error.code, ErrorCode::sensor_not_ready);
  hand.look_from(hand.home(), 2);
  hand.world().sensor().effector_state(RobotState{});  // not synchronised
  EXPECT_EQ(hand.world().measure(3).error.code, ErrorCode::sensor_not_ready);
}

TEST(EyeInHand, CameraDirectedAwayFromThePlaneReportsIt) {
  Hand hand(kPart, kMount + "plane = [0.0, 0.0, 2.0]\n");  // overhead, behind the camera
  const SensorReading v = hand.look_from(hand.home(), 1);
  EXPECT_EQ(v.error.code, ErrorCode::sensor_out_of_range);
  EXPECT_EQ(v.error.error_class, ErrorClass::non_fatal);
}

}  // namespace
}  // namespace mrroc::vsp::eye_in_hand_test
