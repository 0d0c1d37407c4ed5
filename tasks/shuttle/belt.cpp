#include <mrroc/ecp.hpp>
#include <mrroc/robots/conveyor.hpp>

#include "shuttle.hpp"

using namespace mrroc;

/// The behaviours of a belt of the shuttle. states.toml defines their order.
class Belt : public ecp::Task {
  Conveyor belt{*this};

 public:
  Belt() {
    on<Go>([this](const Go& go) { Move({belt}, {}, JointLine{belt, Conveyor::at(go.position), go.speed}); });
    on<Bring>([this](const Bring& bring) {
      const auto half = [&] { return belt.state().joints[0] >= bring.position / 2; };
      Move({belt}, {}, ToolVelocity{belt, {0.04, 0, 0}}.until(When{"half-way", half}));
      tell(HalfWay{belt.state().joints[0]});
      Move({belt}, {}, JointLine{belt, Conveyor::at(bring.position), 0.9});
    });
  }
};

MRROC_ECP(Belt)
