#include <cmath>
#include <cstdio>
#include <mrroc/generators/together.hpp>
#include <mrroc/generators/track_frame.hpp>
#include <mrroc/mp.hpp>
#include <mrroc/robots/irb6.hpp>
#include <mrroc/robots/two_finger_gripper.hpp>
#include <mrroc/sensors/camera.hpp>
#include <mrroc/sensors/conveyor_encoder.hpp>
#include <numbers>

using namespace mrroc;
using std::numbers::pi;

/// Twenty parts come along on a belt in random poses. A camera finds each, the arm follows it and picks it up while the
/// belt runs, and stacks it on a table.
class TrackAndPick : public mp::Task {
  Irb6 arm{*this, "arm"};
  TwoFingerGripper gripper{*this, "gripper"};
  ConveyorEncoder encoder{*this, "encoder"};
  Camera eye{*this, "eye"};

  static constexpr int kParts = 20;
  static constexpr double kPart = 0.060;      // m, between the pads
  static constexpr double kOpen = 0.070;      // 5 mm to each side: camera, base and arm may be off
  static constexpr double kReleased = 0.064;  // beside other parts
  static constexpr double kWaiting = -0.40;   // m, y at which the arm waits for a part
  static constexpr double kAbove = 0.05;      // m
  const Eigen::Vector3d along{0, 1, 0};       // the belt's direction

  Pose at_zero = Pose::Identity();  // of the part at zero of the encoder: z down, x across the belt
  Pose turn = Pose::Identity();     // of the grip in that frame

  /// The arm's tool pose with the pads around (x, y, z) m in the arm's base frame, fingers down.
  Pose around(double x, double y, double z) const { return Irb6::tool_down(x, y, z) * gripper.grip_centre().inverse(); }
  /// The tool in the part's frame, `above` m over the grip.
  Pose grip(double above) const { return Eigen::Translation3d(0, 0, -above) * turn * gripper.grip_centre().inverse(); }
  /// Its axes are the belt's, not the part's: then the tool catches up along the belt and does not swerve.
  MovingFrame part() const {
    return sliding_frame(at_zero, along, encoder.position(), encoder.velocity(), encoder.reading().tick);
  }
  /// Moves to `above` m over the grip, for `dwell` s. The speed is that of the path in the part's frame, m/s.
  TrackFrame track(double above, double dwell = 0, double speed = 0.05, double acceleration = 0.2) {
    const FrameLimits limits{.speed = speed, .acceleration = acceleration};
    return {arm, [this] { return std::optional<MovingFrame>(part()); }, {{grip(above), dwell}}, limits};
  }

  /// Closes across the label's long side, 20 mm below it.
  void remember(const Pose& label) {
    const Eigen::Vector3d at = label.translation(), side = label.linear().col(0);
    at_zero = Irb6::tool_down(at.x(), at.y() - encoder.position(), at.z() - 0.020);
    const double angle = std::remainder(std::atan2(side.y(), side.x()) - pi / 2, pi);
    turn = Eigen::AngleAxisd(-angle, Eigen::Vector3d::UnitZ());
  }

  void measure() {
    Wait({arm, gripper}, {eye, encoder}, Seen{eye} || BeltTravelled{encoder, 4.0}).require<Seen>("no part comes");
    remember(eye.pose());
    Pose ahead = part().pose * grip(kAbove);
    ahead.translation().y() = kWaiting;
    Move({arm, gripper}, {}, JointLine{arm, ahead, 0.9});
    Wait({arm, gripper}, {encoder},
         When{"the part is near", [this] { return part().pose.translation().y() > kWaiting - 0.04; }});
  }

  void pick() {
    Move({arm, gripper}, {encoder}, track(kAbove, 0, 0.15, 0.3));
    // the way down takes 1.3 s, the fingers 2 s
    Move({arm, gripper}, {encoder},
         Together{track(0, 4.0), JointLine{gripper, TwoFingerGripper::at(kPart - 0.003), 1.0}}.until(Gripped{gripper}))
        .require<Gripped>("no part between the fingers");
    Move({arm, gripper}, {encoder}, track(0.03));
  }

  /// The position of part `index` on the table: rows of five, two deep, two high.
  void place(int index) {
    const int row = index / 5 % 2, layer = index / 10;
    const double x = 0.46 + 0.08 * (index % 5), y = 0.61 - 0.09 * row, z = -0.127 + 0.0455 * layer;
    for (const double height : {0.06, 0.0}) {
      const Outcome way =
          Move({arm, gripper}, {}, JointLine{arm, around(x, y, z + height), 0.9}.until(!Gripped{gripper}));
      if (way.by<Negated>()) throw NonFatalError{"the part has been lost"};
    }
    const auto released = [this] { return gripper.state().desired_joints[0] > kPart + 0.002; };
    Move({arm, gripper}, {},
         JointLine{gripper, TwoFingerGripper::at(kReleased), 1.0}.until(When{"released", released}));
    Move({arm, gripper}, {},
         Together{JointLine{arm, around(x, y, z + 0.06), 0.9},
                  JointLine{gripper, TwoFingerGripper::at(kReleased), 1.0}});
  }

  void run() override {
    eye.set_period(10);
    start("belt");
    for (int index = 0; index < kParts; ++index) {
      Move({arm, gripper}, {},
           Together{JointLine{arm, around(0.75, kWaiting, -0.07), 0.9},
                    JointLine{gripper, TwoFingerGripper::at(kOpen), 1.0}});
      measure();
      pick();
      std::printf("part %d picked at %.3f m, belt at %.3f m/s\n", index + 1, part().pose.translation().y(),
                  encoder.velocity());
      place(index);
    }
    stop("belt");
    Move({arm, gripper}, {}, JointLine{arm, arm.parameters().home, 0.9});
  }
};

MRROC_MP(TrackAndPick)
