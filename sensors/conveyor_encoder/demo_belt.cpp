#include <mrroc/ecp.hpp>
#include <mrroc/robots/conveyor.hpp>

using namespace mrroc;

/// Drives the belt 0.6 m forward and a little back, without any message.
class ConveyorEncoderDemoBelt : public ecp::Task {
  Conveyor belt{*this};

  void run() override {
    Move({belt}, {}, JointLine{belt, Conveyor::at(0.6), 0.9});
    Move({belt}, {}, JointLine{belt, Conveyor::at(0.5), 0.9});
  }
};

MRROC_ECP(ConveyorEncoderDemoBelt)
