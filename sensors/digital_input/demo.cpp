#include <cstdio>
#include <mrroc/mp.hpp>
#include <mrroc/sensors/digital_input.hpp>

using namespace mrroc;

/// A ball falls onto a plate with a switch and bounces. One sensor counts every touch, the other waits until the ball
/// lies still.
class DigitalInputDemo : public mp::Task {
  DigitalSensor touched{*this, "touched"};
  DigitalSensor settled{*this, "settled"};

  void run() override {
    Wait({}, {touched, settled}, Risen{touched});
    Wait({}, {touched, settled}, On{settled});
    std::printf("touched %llu times, settled once: %.2f N\n", static_cast<unsigned long long>(touched.rises()),
                settled.level());
    if (touched.rises() < 2) throw NonFatalError{"the ball has not bounced"};
    if (settled.rises() != 1) throw NonFatalError{"the switch is not debounced"};
  }
};

MRROC_MP(DigitalInputDemo)
