// With any arm, below the place where its tool is at home: the force law, the lead-through and the force limits of its
// EDP on the wrench of its force sensor.
#include <cmath>
#include <cstdio>
#include <mrroc/ecp.hpp>
#include <mrroc/generators/cartesian_line.hpp>
#include <mrroc/generators/force_control.hpp>
#include <mrroc/generators/lead_through.hpp>
#include <mrroc/robots/arm.hpp>
#include <string>

#include "require.hpp"

using namespace mrroc;
using mrroc::test::require;

namespace {

template <class AnyArm>
class ForceAtHome : public ecp::Task {
  AnyArm arm{*this};

  double force() const { return -arm.state().wrench[2]; }  // pressing along the tool's z, N
  double height() const { return arm.state().pose.translation().z(); }

  void run() override {
    Move({arm}, {}, Hold{arm, 0.3});
    arm.bias_force();
    const Outcome touched =
        Move({arm}, {}, ToolVelocity{arm, {0, 0, 0.02}}.until(Touching{arm, 5} || Travelled{arm, 0.1}));
    require(!touched.by<Travelled>(), "there is no part under the tool");
    Move({arm}, {}, ForceControl{arm, ForceLaw{}.contact(2, -15)}.until(ElapsedSteps{200}));
    std::printf("force law: %.1f N\n", force());
    require(std::abs(force() - 15) < 1.5, "the force law does not hold 15 N");

    const double pressed = height();
    Guidance hand;  // the pad pushes the tool back, as a hand does
    hand.free = {false, false, true, false, false, false};
    Move({arm}, {}, LeadThrough{arm, hand}.until(ElapsedSteps{200}));
    std::printf("lead-through: %.1f mm, %.1f N\n", 1000 * (height() - pressed), force());
    require(height() > pressed + 0.001 && force() < 5, "the hand does not lead it");

    ErrorCode stop = ErrorCode::none;
    try {
      Move({arm}, {}, CartesianLine{arm, arm.state().pose * Eigen::Translation3d(0, 0, 0.05)});
    } catch (const NonFatalError& error) {
      stop = error.code();
    }
    std::printf("force limit: %s\n", std::string(describe(stop)).c_str());
    require(stop == ErrorCode::force_limit, "the force limit does not stop it");
    Move({arm}, {}, ToolVelocity{arm, {0, 0, -0.02}}.until(Travelled{arm, 0.03}));
    Move({arm}, {}, JointLine{arm, arm.parameters().home});
  }
};

}  // namespace

MRROC_ECP(ForceAtHome<Arm>)
