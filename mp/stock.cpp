#include "mrroc/mp.hpp"

namespace {

/// The stock MP: starts every ECP and waits until all have ended.
class Stock : public mrroc::mp::Task {
  void run() override {
    start_all();
    wait_for_all();
  }
};

}  // namespace

MRROC_MP(Stock)
