#include <limits>
#include <mrroc/ecp.hpp>
#include <mrroc/robots/conveyor.hpp>

using namespace mrroc;

/// Runs the belt at 0.15 m/s until it is stopped.
class Belt : public ecp::Task {
  Conveyor belt{*this};

  void run() override { Move({belt}, {}, ToolVelocity{belt, {0.15, 0, 0}}); }
};

MRROC_ECP(Belt)
