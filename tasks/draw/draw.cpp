#include <cmath>
#include <mrroc/ecp.hpp>
#include <mrroc/generators/blended_path.hpp>
#include <mrroc/generators/cartesian_arc.hpp>
#include <mrroc/generators/cartesian_line.hpp>
#include <mrroc/generators/joint_path.hpp>
#include <mrroc/generators/pose_spline.hpp>
#include <mrroc/robots/irb6.hpp>

using namespace mrroc;

/// Draws a sailing boat into the air in front of the arm: hull, mast, sail, sun, waves and a pennant, each with another
/// generator of a path. Between them the tool moves back from the picture and over to the next stroke.
class Draw : public ecp::Task {
  Irb6 arm{*this};
  PathLimits limits{.speed = 0.08, .acceleration = 0.4};

  /// On the picture, the plane x = 0.75 m: y to the right, z up.
  static Pose at(double y, double z) { return Irb6::tool_down(0.75, y, z); }
  static Pose off(double y, double z) { return Irb6::tool_down(0.71, y, z); }

  void go_over(double y, double z) {
    const Eigen::Vector3d here = arm.state().desired_pose.translation();
    Move({arm}, {}, JointPath{arm, std::vector<Pose>{off(here.y(), here.z()), off(y, z), at(y, z)}, 0.9});
  }

  void hull() {
    go_over(-0.12, 0.02);
    Move({arm}, {},
         BlendedPath{arm,
                     {{at(-0.09, -0.05), 0.02}, {at(0.07, -0.05), 0.03}, {at(0.12, 0.02), 0.008}, {at(-0.12, 0.02)}},
                     limits});
  }

  void mast_and_sail() {
    go_over(0.0, 0.02);
    Move({arm}, {}, CartesianLine{arm, at(0.0, 0.15), limits});
    Move({arm}, {}, CartesianArc{arm, at(0.075, 0.075).translation(), at(0.08, 0.03), limits});
  }

  void sun() {
    go_over(-0.10, 0.10);
    Move({arm}, {}, CartesianArc{arm, Circle{.centre = at(-0.12, 0.10).translation(), .axis = {1, 0, 0}}, limits});
  }

  /// Up and down, swaying by 0.1 rad.
  void waves() {
    go_over(-0.16, -0.08);
    std::vector<Pose> crests;
    for (int i = 1; i <= 8; ++i) {
      const double sign = i % 2 == 0 ? -1 : 1;
      const Eigen::AngleAxisd sway(0.1 * sign, Eigen::Vector3d::UnitX());
      crests.push_back(at(-0.16 + 0.04 * i, -0.08 + 0.008 * sign) * sway);
    }
    crests.push_back(at(0.18, -0.08));
    Move({arm}, {}, PoseSpline{arm, crests, SplineKind::cubic, limits});
  }

  /// In exactly 3 s.
  void pennant() {
    go_over(0.0, 0.15);
    const std::vector<TimedPose> ripple{{at(-0.02, 0.16), 1.0}, {at(-0.04, 0.15), 2.0}, {at(-0.06, 0.16), 3.0}};
    Move({arm}, {}, PoseSpline{arm, ripple, SplineKind::quintic});
  }

  void run() override {
    Wait({arm}, {}, ElapsedSteps{0});  // read the arm's state
    hull();
    mast_and_sail();
    sun();
    waves();
    pennant();
    Move({arm}, {}, JointLine{arm, arm.parameters().home});
  }
};

MRROC_ECP(Draw)
