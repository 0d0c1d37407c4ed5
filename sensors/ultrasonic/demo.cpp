#include <mrroc/mp.hpp>
#include <mrroc/sensors/ultrasonic.hpp>

using namespace mrroc;

/// Waits until the post is in the cone and until it is before the transducer, then watches for two swings.
class UltrasonicDemo : public mp::Task {
  Ultrasonic cone{*this, "cone"};
  Ultrasonic ray{*this, "ray"};
  Ultrasonic rough{*this, "rough"};
  Ultrasonic smooth{*this, "smooth"};

  void run() override {
    const Outcome in_cone = Wait({}, {cone, ray, rough, smooth}, Closer{cone, 1.5});
    const Outcome before_it = Wait({}, {cone, ray, rough, smooth}, Closer{ray, 1.5} || ElapsedSteps{200});
    if (!before_it.by<Closer>()) throw NonFatalError{"the post has not come before the transducer"};
    if (before_it.end_tick <= in_cone.end_tick) throw NonFatalError{"the cone is not wider than the ray"};
    Wait({}, {cone, ray, rough, smooth}, ElapsedSteps{300});
  }
};

MRROC_MP(UltrasonicDemo)
