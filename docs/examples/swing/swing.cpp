#include <cstdio>
#include <mrroc/ecp.hpp>
#include <mrroc/robots/irb6.hpp>

#include "beyond.hpp"
#include "to_and_fro.hpp"

using namespace mrroc;

/// The arm swings by half a radian, until the protractor has seen 0.3 rad.
class Swing : public ecp::Task {
  Irb6 arm{*this};
  Protractor protractor{*this, "protractor"};

  void run() override {
    const Outcome whole = Move({arm}, {protractor}, ToAndFro{arm, 0.2, 0.5});
    std::printf("there and back: %.3f rad after %.2f s\n", protractor.angle(), whole.duration);
    const Outcome part = Move({arm}, {protractor}, ToAndFro{arm, 0.5, 0.5}.until(Beyond{protractor, 0.3}));
    if (!part.by<Beyond>()) throw NonFatalError{"the arm has not passed 0.3 rad"};
    std::printf("beyond 0.3 rad after %.2f s\n", part.duration);
  }
};

MRROC_ECP(Swing)
