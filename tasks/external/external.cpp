#include <mrroc/ecp.hpp>
#include <mrroc/generators/external.hpp>
#include <mrroc/robots/irb6.hpp>

using namespace mrroc;

/// Yields its arm: it follows the trajectories that 'mrroc follow', an event of the deployment or a node of ROS 2 send,
/// until the operator gives a trigger. Then it moves home.
class Yield : public ecp::Task {
  Irb6 arm{*this};

  void run() override {
    Move({arm}, {}, External{arm}.until(OperatorTrigger{*this}));
    Move({arm}, {}, JointLine{arm, arm.parameters().home});
  }
};

MRROC_ECP(Yield)
