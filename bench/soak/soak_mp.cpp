#include <cstdio>
#include <vector>

#include "cooperative_transfer/transfer.hpp"

using namespace mrroc;
using namespace mrroc::transfer;

namespace {

/// Laps after which the bar is put down and gripped again: simulated pads let it creep down by 0.1 mm a lap.
constexpr int kLapsOfAGrip = 40;

std::vector<Pose> reversed(const std::vector<Pose>& path) { return {path.rbegin(), path.rend()}; }

/// Back to just above the stands from which the bar was lifted, and onto them.
std::vector<Pose> back() { return {way::lift().back(), bar_at(0.75, 0, 0.51)}; }
std::vector<Pose> onto_the_stands() { return {back().back(), bar_at(0.75, 0, 0.49)}; }  // it lies at 0.50

}  // namespace

/// The endless variant of the task cooperative_transfer: carries the bar forth and back until the operator gives a
/// trigger, which the deployment of the soak does at its tick. Prints the elapsed time after every lap.
class Soak : public Transfer {
  void run() override {
    set_tools();
    take_up();
    for (int lap = 1; !take_trigger(); ++lap) {
      carry_along(way::carry(), kFree);
      carry_along(reversed(way::carry()), kFree);
      std::printf("lap %d %.3f\n", lap, static_cast<double>(tick()) * servo_period());
      std::fflush(stdout);
      if (lap % kLapsOfAGrip == 0) grip_anew();
    }
    carry_along(way::carry(), kFree);
    carry_along(way::lower(), kNear);
    put_down(way::put_down());
  }

  void grip_anew() {
    carry_along(back(), kNear);
    put_down(onto_the_stands());
    take_up();
  }
};

MRROC_MP(Soak)
