// A receiver of the task hand_over that pulls only after some seconds, and never if they are long.
#include "mrroc/ecp.hpp"
#include "mrroc/robots/irb6.hpp"
#include "tasks/hand_over/hand_over.hpp"

using namespace mrroc;

namespace mrroc::test {
namespace {

class Late : public ecp::Task {
  Irb6 arm{*this};

 public:
  Late() {
    on<Reach>([this](const Reach& to) {
      arm.set_tool(Pose{Eigen::Translation3d{0, -0.08, 0.378}});
      const Pose place = Irb6::tool_down(to.x, to.y, to.z);
      Move({arm}, {}, JointLine{arm, Eigen::Translation3d{0, 0, 0.06} * place, 0.9});
      Move({arm}, {}, JointLine{arm, place, 0.2});
      Move({arm}, {}, Hold{arm, 0.2});
      arm.bias_force();
    });
    on<Take>([this](const Take&) {
      ForceLaw law = ForceLaw{}.guarded(0).guarded(1).guarded(2).guarded(3).guarded(4).guarded(5);
      law.admittance << 3e-4, 3e-4, 3e-4, 3e-3, 3e-3, 3e-3;
      Move({arm}, {}, ForceControl{arm, law});
      Move({arm}, {}, Hold{arm, ask_number("How long does the receiver wait?", 0, 60)});
      Move({arm}, {}, ForceControl{arm, law.contact(1, -10)});
    });
  }
};

}  // namespace
}  // namespace mrroc::test

MRROC_ECP(mrroc::test::Late)
