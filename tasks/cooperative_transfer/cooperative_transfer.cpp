#include "transfer.hpp"

using namespace mrroc;
using namespace mrroc::transfer;

/// Two arms grip a bar that lies on two stands, carry it together along a path in space, turning it, and put
/// it down on two others.
class CooperativeTransfer : public Transfer {
  void run() override {
    set_tools();
    take_up();
    for (const auto& [path, limits] : {std::pair{way::carry(), kFree}, std::pair{way::lower(), kNear}}) {
      const Outcome way = carry_along(path, limits);
      std::printf("travelled for %.2f s, skew %llu ticks\n", way.duration, static_cast<unsigned long long>(way.skew));
    }
    put_down(way::put_down());
  }
};

MRROC_MP(CooperativeTransfer)
