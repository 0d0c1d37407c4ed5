#include <mrroc/mp.hpp>
#include <mrroc/robots/irb6.hpp>
#include <mrroc/robots/slide.hpp>
#include <mrroc/sensors/gauge.hpp>

using namespace mrroc;

/// A robot of the project moves until its sensor triggers, while one of the framework holds.
class Measure : public mp::Task {
  Slide slide{*this, "slide"};
  Irb6 arm{*this, "arm"};
  Gauge gauge{*this, "gauge"};

  void run() override {
    const When enough{"enough", [this] { return gauge.place() > 0.02; }};
    const Outcome end = Move({slide, arm}, {gauge}, JointLine{slide, JointVector::Constant(1, 0.3), 1.0}.until(enough));
    if (!end.by("enough")) throw NonFatalError{"the gauge has not detected the carriage"};
  }
};

MRROC_MP(Measure)
