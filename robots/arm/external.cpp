#include <mrroc/ecp.hpp>
#include <mrroc/generators/external.hpp>
#include <mrroc/robots/arm.hpp>

using namespace mrroc;

/// Yields the arm to other programs, MoveIt for example, until the operator gives a trigger. Then it moves home.
class Yield : public ecp::Task {
  Arm arm{*this};

  void run() override {
    Move({arm}, {}, External{arm}.until(OperatorTrigger{*this}));
    Move({arm}, {}, JointLine{arm, arm.parameters().home});
  }
};

MRROC_ECP(Yield)
