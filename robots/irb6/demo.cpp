#include <mrroc/ecp.hpp>
#include <mrroc/robots/irb6.hpp>

using namespace mrroc;

/// A tour of the workspace: a square over the table, the posture of synchronisation, home.
class Tour : public ecp::Task {
  Irb6 arm{*this};

  void run() override {
    for (const auto& [x, y] : {std::pair{0.80, 0.25}, {0.60, 0.25}, {0.60, -0.25}, {0.80, -0.25}}) {
      Move({arm}, {}, JointLine{arm, Irb6::tool_down(x, y, 0.0), 0.9});
    }
    JointVector upright(6);
    upright << 0, -1.5708, 0, 0, 4.7124, 1.5708;
    Move({arm}, {}, JointLine{arm, upright, 0.9});
    Move({arm}, {}, JointLine{arm, arm.parameters().home, 0.9});
  }
};

MRROC_ECP(Tour)
