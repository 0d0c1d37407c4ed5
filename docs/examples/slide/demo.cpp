#include <mrroc/ecp.hpp>
#include <mrroc/robots/slide.hpp>

using namespace mrroc;

/// From end to end and home.
class EndToEnd : public ecp::Task {
  Slide slide{*this};

  void run() override {
    for (const double x : {0.4, -0.4, 0.0}) Move({slide}, {}, JointLine{slide, JointVector::Constant(1, x)});
  }
};

MRROC_ECP(EndToEnd)
