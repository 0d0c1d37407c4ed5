// A belt with three behaviours.
#include "mrroc/ecp.hpp"
#include "mrroc/robots/conveyor.hpp"
#include "system/programs/coordination.hpp"

using namespace mrroc;

namespace mrroc::test {
namespace {

class Belt : public ecp::Task {
  Conveyor belt{*this};

 public:
  Belt() {
    on<Go>([this](const Go& go) {
      Move({belt}, {}, JointLine{belt, Conveyor::at(go.position), go.speed});
      arrived("place");
    });
    on<Run>([this](const Run& run) {
      double speed = run.speed;
      for (;;) {
        const Outcome end = Move(
            {belt}, {}, ToolVelocity{belt, {speed, 0, 0}}.until(When{"faster", [this] { return heard<Faster>(); }}));
        if (end.ending == Ending::end_motion) break;
        speed = take<Faster>()->speed;
        arrived("message");
      }
      arrived("end-motion");
    });
    on<Ask>([this](const Ask&) {
      const double place = ask_number("Where to?", 0, 0.2);
      tell_operator("On the way.");
      Move({belt}, {}, JointLine{belt, Conveyor::at(place), 0.9});
      arrived("answer");
    });
  }

 private:
  void arrived(const char* by) { tell(Arrived{belt.state().desired_joints[0], tick(), {by}}); }
};

}  // namespace
}  // namespace mrroc::test

MRROC_ECP(mrroc::test::Belt)
