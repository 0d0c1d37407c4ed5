#include <mrroc/ecp.hpp>
#include <mrroc/robots/irb60.hpp>

using namespace mrroc;

/// A tour of the workspace: a square over the pallet, the posture of synchronisation, home.
class Tour : public ecp::Task {
  Irb60 arm{*this};

  void run() override {
    for (const auto& [x, y] : {std::pair{1.35, 0.40}, {1.00, 0.40}, {1.00, -0.40}, {1.35, -0.40}}) {
      Move({arm}, {}, JointLine{arm, Irb60::tool_down(x, y, 0.0), 0.9});
    }
    JointVector upright(6);
    upright << 0, -1.5708, 0, 0, 4.7124, 1.5708;
    Move({arm}, {}, JointLine{arm, upright, 0.9});
    Move({arm}, {}, JointLine{arm, arm.parameters().home, 0.9});
  }
};

MRROC_ECP(Tour)
