#include "hand_over.hpp"

#include <cstdio>
#include <mrroc/mp.hpp>
#include <mrroc/robots/two_finger_gripper.hpp>
using namespace mrroc;

/// Bars come along on a belt. One arm picks each and holds it out; the other grips it in the air and pulls; the first
/// detects the pull and releases the bar. While the second lays the bar on a table, the first fetches the next.
class ServoChannel : public mp::Task {
  TwoFingerGripper giver_hand{*this, "giver_hand"}, receiver_hand{*this, "receiver_hand"};

  void open(TwoFingerGripper& hand) { Move({hand}, {}, JointLine{hand, TwoFingerGripper::at(0.070), 1.0}); }
  void grip(TwoFingerGripper& hand) {
    Move({hand}, {}, JointLine{hand, TwoFingerGripper::at(0.057), 1.0}.until(Gripped{hand}))
        .require<Gripped>("no bar between the fingers");
  }

  void fetch() {
    perform("belt", Bring{});
    perform("giver", *take<Reach>("belt"));
    grip(giver_hand);
    perform("giver", Reach{0.8, 0.15, 0.15});
  }
  void lay_down(int place) {
    if (place > 0) perform("receiver", Reach{0.6 + 0.1 * place, -0.1, -0.14});  // the table is 10 mm higher
    open(receiver_hand);
    perform("receiver", Reach{0.8, 0.0, 0.2});  // its waiting position
  }

  void run() override {
    for (int bar = 1; bar <= 3; ++bar) {
      concurrently({[this] { fetch(); }, [this, bar] { lay_down(bar - 1); }});
      start("giver", Give{});
      perform("receiver", Reach{0.8, 0.25, 0.15});
      start("receiver", Take{});
      grip(receiver_hand);
      end_motion("receiver");  // ends its compliance: now it pulls
      wait_for_all({"giver"});
      std::printf("bar %d: the giver detects the pull and lets go\n", bar);
      open(giver_hand);
      end_motion("receiver");
      perform("giver", Reach{0.8, -0.25, 0.0});
    }
    lay_down(3);
  }
};

MRROC_MP(ServoChannel)
