#include <mrroc/conditions/digital_input.hpp>
#include <mrroc/ecp.hpp>
#include <mrroc/robots/irb6.hpp>

using namespace mrroc;

/// The teaching person, played by a second arm: waits aside until the lamp is on, takes the handle, which springs
/// hold to its hand while its outputs 0 to 2 are on, leads it about, lets go and presses the button.
class Person : public ecp::Task {
  Irb6 arm{*this};

  void set(std::uint16_t outputs) {
    ControllerIo signals;
    signals.digital = outputs;
    arm.set_outputs(signals);
  }

  void run() override {
    const Pose aside = Irb6::tool_down(0.60, 0, 0.12), handle = Irb6::tool_down(0.75, 0, 0);
    Move({arm}, {}, JointLine{arm, aside});
    Wait({arm}, {}, DigitalInput{arm, 0});
    Move({arm}, {}, JointLine{arm, handle});
    set(0b0111);
    Move({arm}, {}, Hold{arm, 1.0});
    for (const auto& [x, y, z, turn, tilt] : {std::tuple{0.72, 0.10, 0.05, 0.2, 0.0},
                                              {0.80, 0.04, 0.08, 0.3, 0.1},
                                              {0.78, -0.10, 0.02, -0.2, 0.15},
                                              {0.70, -0.06, -0.05, -0.1, 0.0},
                                              {0.74, 0.03, 0.04, 0.0, -0.1}}) {
      Pose pose = Irb6::tool_down(x, y, z);
      pose.rotate(Eigen::AngleAxisd(turn, Eigen::Vector3d::UnitZ()) *
                  Eigen::AngleAxisd(tilt, Eigen::Vector3d::UnitY()));
      Move({arm}, {}, JointLine{arm, pose, 0.4});
    }
    Move({arm}, {}, Hold{arm, 1.0});
    set(0b1000);  // lets go and presses the button
    Move({arm}, {}, Hold{arm, 0.5});
    set(0);
    Move({arm}, {}, JointLine{arm, aside});
  }
};

MRROC_ECP(Person)
