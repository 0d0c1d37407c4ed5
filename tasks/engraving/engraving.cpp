#include <cstdio>
#include <mrroc/ecp.hpp>
#include <mrroc/generators/blended_path.hpp>
#include <mrroc/generators/cartesian_line.hpp>
#include <mrroc/generators/pose_spline.hpp>
#include <mrroc/robots/serial_parallel.hpp>

#include "config/resources.hpp"
#include "engraving/engrave.hpp"
#include "engraving/lettering.hpp"
#include "engraving/surface.hpp"

using namespace mrroc;
using engraving::Lettering, engraving::Points, engraving::Stroke, engraving::Surface;

/// Engraves a board of unknown shape: touches it at a grid of points, fits a surface through them, and
/// follows the strokes of the letters at a constant depth below, the spindle at right angles to the surface.
class Engraving : public ecp::Task {
  SerialParallel machine{*this};

  static constexpr double kClearance = 0.004, kBall = 0.001;  // m: above the board on the way; the radius of the stylus
  static inline const Eigen::Vector2d kProbed{0.18, 0.045};   // m: right and away, of the probed part
  static constexpr PathLimits kTravel{.speed = 0.08, .acceleration = 0.6};
  static constexpr PathLimits kPlunge{.speed = 0.01, .acceleration = 0.1}, kFeed{.speed = 0.02, .acceleration = 0.2};

  /// A point of the board (m from its middle: right, away from the reader) in the machine's base frame.
  static Eigen::Vector2d at(const Eigen::Vector2d& place) { return {0.05 + place.y(), -place.x()}; }
  static Pose upright(const Eigen::Vector2d& xy, double z) { return SerialParallel::tool_down(xy.x(), xy.y(), z); }
  Eigen::Vector3d tip() const { return machine.state().pose.translation(); }

  void approach(double speed) {
    const auto touching = Touching{machine, 2} || Travelled{machine, 0.02};
    const Outcome end = Move({machine}, {}, ToolVelocity{machine, {0, 0, speed}}.until(touching));
    if (end.by<Travelled>()) throw NonFatalError{"no board under the probe"};
  }

  /// Moves down until contact with the board, fast and then, from 1 mm above, slowly.
  void touch() {
    approach(0.01);
    Move({machine}, {}, CartesianLine{machine, upright(tip().head<2>(), tip().z() + 0.001), kTravel});
    machine.set_macrostep(5, 3);  // checks the force every 10 ms
    approach(0.002);
    machine.set_macrostep(10, 8);
  }

  /// Positions of the ball's centre where it touches the board.
  std::vector<Eigen::Vector3d> probe(int columns, int rows) {
    const Pose cutter = machine.state().tool;
    machine.set_outputs({.digital = 1});                              // extend the stylus
    machine.set_tool(cutter * Eigen::Translation3d(0.03, 0, 0.004));  // the centre of its ball
    std::vector<Eigen::Vector3d> touched;
    for (const Eigen::Vector2d& place : engraving::grid(kProbed, columns, rows)) {
      if (touched.empty()) {
        Move({machine}, {}, JointLine{machine, upright(at(place), -0.54)});
        Move({machine}, {}, Hold{machine, 0.3});  // let it settle before the force is zeroed
        machine.bias_force();
      } else {
        const double above = tip().z() + kClearance;
        const BlendPoint up{upright(tip().head<2>(), above), 0.002}, next{upright(at(place), above)};
        Move({machine}, {}, BlendedPath{machine, {up, next}, kTravel});
      }
      touch();
      touched.push_back(tip());
    }
    Move({machine}, {}, JointLine{machine, machine.parameters().home});
    machine.set_outputs({});
    machine.set_tool(cutter);
    return touched;
  }

  void carve(const Stroke& stroke, const Surface& board, double depth) {
    const auto tool = [&](const Eigen::Vector2d& place, double inside) { return board.tool_at(at(place), inside); };
    Move({machine}, {}, CartesianLine{machine, tool(stroke.front().front(), -kClearance), kTravel});
    Move({machine}, {}, CartesianLine{machine, tool(stroke.front().front(), depth), kPlunge});
    for (const Points& piece : stroke) {
      std::vector<Pose> poses;
      for (const Eigen::Vector2d& place : piece) poses.push_back(tool(place, depth));
      Move({machine}, {}, PoseSpline{machine, poses, SplineKind::cubic, kFeed});
    }
    Move({machine}, {}, CartesianLine{machine, tool(stroke.back().back(), -kClearance), kTravel});
  }

 public:
  Engraving() {
    on<Engrave>([this](const Engrave& order) {
      const Lettering letters(config::type_file("tasks", "engraving", "capitals.txt"));
      const auto strokes = letters.strokes(std::string(order.inscription.view()), kProbed, order.height, 0.002);
      Move({machine}, {}, Hold{machine, 0.1});
      const Surface board(probe(order.columns, order.rows), kBall, order.rows, order.columns);
      std::printf("touched %d times, %.1f um RMS off the surface\n", order.columns * order.rows,
                  1e6 * board.residual());
      for (const Stroke& stroke : strokes) carve(stroke, board, order.depth);
      Move({machine}, {}, JointLine{machine, machine.parameters().home});
    });
  }
};

MRROC_ECP(Engraving)
