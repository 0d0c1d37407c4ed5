#include <cmath>
#include <cstdio>
#include <mrroc/mp.hpp>
#include <mrroc/sensors/conveyor_encoder.hpp>

using namespace mrroc;

/// Watches a belt that another program drives, by an encoder as fine as the belt's own and by a coarse one: reports
/// each 0.15 m, and the reversal of the belt.
class ConveyorEncoderDemo : public mp::Task {
  ConveyorEncoder fine{*this, "fine"};
  ConveyorEncoder coarse{*this, "coarse"};

  void run() override {
    start("belt");
    for (int mark = 1; mark <= 3; ++mark) {
      Wait({}, {fine, coarse}, BeltTravelled{fine, 0.15});
      std::printf("belt at %.3f m, %.2f m by the coarse encoder, %.3f m/s\n", fine.position(), coarse.position(),
                  fine.velocity());
    }
    Wait({}, {fine, coarse}, When{"belt turns back", [this] { return fine.velocity() < -0.01; }});
    Wait({}, {fine, coarse}, When{"belt rests", [this] { return std::abs(fine.velocity()) < 1e-4; }});
    wait_for_all();
  }
};

MRROC_MP(ConveyorEncoderDemo)
