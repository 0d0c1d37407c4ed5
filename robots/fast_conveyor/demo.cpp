#include <mrroc/ecp.hpp>
#include <mrroc/robots/fast_conveyor.hpp>
#include <mrroc/sensors/conveyor_encoder.hpp>

using namespace mrroc;

/// Parts ride along the belt: half a metre by position, then at 0.15 m/s until the encoder has counted 0.6 m, then a
/// little back.
class FastConveyorDemo : public ecp::Task {
  FastConveyor belt{*this};
  ConveyorEncoder encoder{*this, "encoder"};

  void run() override {
    Move({belt}, {encoder}, JointLine{belt, FastConveyor::at(0.5), 0.9});
    Move({belt}, {encoder}, Hold{belt, 0.5});
    encoder.bias();
    Move({belt}, {encoder}, ToolVelocity{belt, {0.15, 0, 0}, {0, 0, 0}, 0.5}.until(BeltTravelled{encoder, 0.6}));
    Move({belt}, {encoder}, Hold{belt, 0.5});
    Move({belt}, {encoder}, JointLine{belt, FastConveyor::at(1.0), 0.9});
  }
};

MRROC_ECP(FastConveyorDemo)
