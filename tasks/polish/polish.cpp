#include <cmath>
#include <cstdio>
#include <mrroc/conditions/path_travelled.hpp>
#include <mrroc/ecp.hpp>
#include <mrroc/generators/contact_search.hpp>
#include <mrroc/generators/guarded_motion.hpp>
#include <mrroc/generators/impedance.hpp>
#include <mrroc/generators/surface_following.hpp>
#include <mrroc/robots/irb6.hpp>

using namespace mrroc;

/// Polishes a curved workpiece of unknown shape: touches it, probes it at a grid, moves over it from point to
/// point with the tool turned to its normal, and rubs a spot in circles on a spring.
class Polish : public ecp::Task {
  Irb6 arm{*this};

  /// The middle of the workpiece, and the extent of the grid from it.
  static constexpr double kX = 0.80, kY = 0, kReach = 0.06;

  void lift(double height) {
    Move({arm}, {}, Hold{arm, 0.2});
    Move({arm}, {}, ToolVelocity{arm, {0, 0, -0.05}}.until(Travelled{arm, height}));
    Move({arm}, {}, Hold{arm, 0.3});
  }

  void run() override {
    arm.set_tool(Pose(Eigen::Translation3d(0, 0, 0.34)));  // the middle of the pad
    Move({arm}, {}, JointLine{arm, Irb6::tool_down(kX, kY, -0.06)});
    Move({arm}, {}, Hold{arm, 0.5});
    arm.bias_force();

    GuardedMotion down{arm, {0, 0, 0.02}, 4};
    Move({arm}, {}, down.until(Travelled{arm, 0.15}));
    if (!down.touched()) throw NonFatalError{"there is no workpiece"};
    const double top = down.touched()->translation().z();
    lift(0.015);

    const Pose corner = Irb6::tool_down(kX - kReach, kY + kReach, top + 0.01);
    ContactSearch probing{arm, grid_of_probes(corner, 3, 3, kReach, 0.05), {.speed = 0.01}};
    Move({arm}, {}, probing);
    std::vector<Eigen::Vector3d> path;  // back and forth, as it was probed
    for (const auto& place : probing.touched()) {
      if (!place) throw NonFatalError{"the workpiece is too small"};
      path.push_back(*place);
      std::printf("touched (%.1f, %.1f, %.2f) mm\n", 1e3 * place->x(), 1e3 * place->y(), 1e3 * place->z());
    }

    SurfaceContact contact;
    contact.admittance = 0.004;  // m/(N s): 16 / s on a fixture of 4 kN/m
    contact.turn_to_normal = true;
    lift(0.01);
    Move({arm}, {}, JointLine{arm, Irb6::tool_down(path[0].x(), path[0].y(), path[0].z() + 0.002)});
    Move({arm}, {}, SurfaceFollowing{arm, 8, path, 0.02, contact});
    lift(0.02);

    Move({arm}, {}, JointLine{arm, Irb6::tool_down(kX, kY, top + 0.01)});
    const Pose spot = Irb6::tool_down(kX, kY, top - 0.008);  // the spring is pressed in by 8 mm
    const auto circle = [spot](double seconds) {
      const double angle = 1.5 * seconds, radius = 0.03;
      MovingFrame frame;
      frame.pose = spot;
      frame.pose.translation() += radius * Eigen::Vector3d(std::cos(angle), std::sin(angle), 0);
      frame.twist.head<3>() = 1.5 * radius * Eigen::Vector3d(-std::sin(angle), std::cos(angle), 0);
      return frame;
    };
    ImpedanceParameters spring;
    spring.stiffness[2] = 1000;  // N/m
    spring.damping[2] = 200;     // N s/m
    Move({arm}, {}, Impedance{arm, circle, spring}.until(PathTravelled{arm, 0.6}));
    lift(0.02);
    Move({arm}, {}, JointLine{arm, arm.parameters().home});
  }
};

MRROC_ECP(Polish)
