// A belt that runs until it is stopped; the one named "failing" then commands more than it can do.
#include "mrroc/ecp.hpp"
#include "mrroc/robots/conveyor.hpp"

using namespace mrroc;

namespace {

class Subordinate : public ecp::Task {
  Conveyor belt{*this};

  void run() override {
    const bool failing = process_name() == "failing";
    ToolVelocity steady(belt, {0.02, 0, 0});
    if (failing) steady.until(ElapsedSteps{20});
    Move({belt}, {}, steady);
    Move({belt}, {}, ToolVelocity{belt, {0.2, 0, 0}});
  }
};

}  // namespace

MRROC_ECP(Subordinate)
