#include <mrroc/ecp.hpp>
#include <mrroc/robots/irb6_five_axis.hpp>

using namespace mrroc;

/// A tour of the workspace: a square with the tool straight down, the tool forward, a pose that five axes cannot reach,
/// home.
class Tour : public ecp::Task {
  Irb6FiveAxis arm{*this};

  void run() override {
    for (const auto& [x, y] : {std::pair{0.70, 0.20}, {0.55, 0.20}, {0.55, -0.20}, {0.70, -0.20}}) {
      Move({arm}, {}, JointLine{arm, Irb6FiveAxis::tool_down(x, y, 0.05), 0.9});
    }
    JointVector forward(5);
    forward << 0, -1.5708, 0, 0, 0;
    Move({arm}, {}, JointLine{arm, forward, 0.9});
    try {
      const Pose sideways = Irb6FiveAxis::tool_down(0.65, 0, 0) * Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitX());
      Move({arm}, {}, JointLine{arm, sideways, 0.9});
    } catch (const NonFatalError&) {
      // the tool would leave the arm's plane: refused before anything moves
    }
    Move({arm}, {}, JointLine{arm, arm.parameters().home, 0.9});
  }
};

MRROC_ECP(Tour)
