#include <cstdio>
#include <mrroc/mp.hpp>
#include <mrroc/sensors/operator_input.hpp>

using namespace mrroc;

/// Asks how many parts there are, then the weight of each.
class OperatorInputDemo : public mp::Task {
  OperatorInput parts{*this, "parts"};
  OperatorInput weight{*this, "weight"};

  void run() override {
    const double count = ask(parts);
    double sum = 0;
    for (int part = 1; part <= count; ++part) sum += ask(weight);
    std::printf("%g parts of %g kg together\n", count, sum);
  }
};

MRROC_MP(OperatorInputDemo)
