#include <mrroc/ecp.hpp>
#include <mrroc/robots/conveyor.hpp>
#include <mrroc/sensors/conveyor_encoder.hpp>

using namespace mrroc;

/// Parts ride along the belt: half a metre by position, then at four fifths of the belt's speed until the encoder has
/// counted 0.6 m, then a little back.
class ConveyorDemo : public ecp::Task {
  Conveyor belt{*this};
  ConveyorEncoder encoder{*this, "encoder"};

  void run() override {
    Move({belt}, {encoder}, JointLine{belt, Conveyor::at(0.5), 0.9});
    Move({belt}, {encoder}, Hold{belt, 0.5});
    encoder.bias();
    const double speed = 0.8 * belt.parameters().axes.front().velocity_max;
    Move({belt}, {encoder}, ToolVelocity{belt, {speed, 0, 0}}.until(BeltTravelled{encoder, 0.6}));
    Move({belt}, {encoder}, Hold{belt, 0.5});
    Move({belt}, {encoder}, JointLine{belt, Conveyor::at(1.0), 0.9});
  }
};

MRROC_ECP(ConveyorDemo)
