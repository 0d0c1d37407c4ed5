#include <mrroc/ecp.hpp>
#include <mrroc/robots/irb6.hpp>
#include <mrroc/sensors/force_torque.hpp>

using namespace mrroc;

/// Turns the tool about without contact: the compensated sensor measures no weight in any posture, the plain one does.
class ForceTorqueDemo : public ecp::Task {
  Irb6 arm{*this};
  ForceTorque wrist{*this, "wrist"};
  ForceTorque plain{*this, "plain"};

  void run() override {
    JointVector posture = arm.parameters().home;
    for (const auto& [pitch, roll, tool] :
         {std::tuple{0.0, 0.0, 0.0}, {0.9, 0.0, 0.5}, {0.3, -1.6, -0.8}, {-0.5, -3.0, -1.5}, {-0.2, -4.2, 0.0}}) {
      posture.tail<3>() = arm.parameters().home.tail<3>() + Eigen::Vector3d(pitch, roll, tool);
      Move({arm}, {wrist, plain}, JointLine{arm, posture});
      Move({arm}, {wrist, plain}, Hold{arm, 0.6});
      if (wrist.force().norm() > 0.3 || wrist.torque().norm() > 0.03) throw NonFatalError{"the tool's weight remains"};
      if (plain.force().norm() < 5) throw NonFatalError{"the plain sensor measures no weight"};
    }
  }
};

MRROC_ECP(ForceTorqueDemo)
