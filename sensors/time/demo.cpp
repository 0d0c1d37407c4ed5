#include <cstdio>
#include <mrroc/mp.hpp>
#include <mrroc/sensors/time.hpp>

using namespace mrroc;

/// A stop watch: waits for a moment of the deployment's time, then takes two laps, each timed from zero.
class TimeDemo : public mp::Task {
  Time watch{*this, "watch"};

  void run() override {
    Wait({}, {watch}, TimeReached{watch, 1.0});
    for (const double lap : {0.5, 1.5}) {
      watch.bias();
      Wait({}, {watch}, TimeReached{watch, lap});
      std::printf("lap of %.3f s ended at %.3f s, tick %llu\n", lap, watch.time(),
                  static_cast<unsigned long long>(watch.tick()));
    }
  }
};

MRROC_MP(TimeDemo)
