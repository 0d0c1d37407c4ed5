// Changes the arm's regulators and its outputs, and waits for an input that is connected to one of them.
#include <cmath>
#include <cstdio>

#include "mrroc/ecp.hpp"
#include "mrroc/robots/irb6.hpp"
#include "require.hpp"

using namespace mrroc;
using mrroc::test::require;

namespace {

class Changes : public ecp::Task {
  Irb6 arm{*this};

  void run() override {
    Wait({arm}, {}, !DigitalInput{arm, 0});
    ControllerIo outputs;
    outputs.set(3, true);
    outputs.analog[1] = 2.5;
    arm.set_outputs(outputs);
    const Outcome came = Wait({arm}, {}, DigitalInput{arm, 0});
    require(arm.state().outputs == outputs, "the outputs are different");
    std::printf("input 0 came after %llu steps\n", static_cast<unsigned long long>(came.steps));

    try {
      arm.use_regulators("stiff");
      throw NonFatalError(ErrorCode::task_failed, "an unknown regulator set was accepted");
    } catch (const NonFatalError& error) {
      if (error.detail().find("expected one of: standard, soft") == std::string::npos) throw;
    }
    arm.use_regulators("soft");
    Move({arm}, {}, JointLine{arm, Irb6::tool_down(0.70, 0.1, 0.05)});
    Move({arm}, {}, Hold{arm, 0.5});
    require(arm.state().regulators == 1, "it uses other regulators");
    require((arm.state().joints - arm.state().desired_joints).cwiseAbs().maxCoeff() < 2e-3,
            "it did not reach its target");
    std::printf("moved with soft regulators\n");
  }
};

}  // namespace

MRROC_ECP(Changes)
