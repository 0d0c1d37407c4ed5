#include <mrroc/mp.hpp>
#include <mrroc/sensors/infrared.hpp>

using namespace mrroc;

/// Sees the plate come and go, twice.
class InfraredDemo : public mp::Task {
  Infrared eye{*this, "eye"};
  Infrared chattering{*this, "chattering"};

  void run() override {
    for (int visit = 0; visit < 2; ++visit) {
      Wait({}, {eye, chattering}, Presence{eye});
      Wait({}, {eye, chattering}, Nearer{eye, 0.2});
      Wait({}, {eye, chattering}, !Presence{eye});
    }
  }
};

MRROC_MP(InfraredDemo)
