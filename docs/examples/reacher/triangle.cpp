#include <mrroc/ecp.hpp>
#include <mrroc/generators/cartesian_line.hpp>
#include <mrroc/robots/arm.hpp>

using namespace mrroc;

/// Three straight lines in front of the arm.
class Triangle : public ecp::Task {
  Arm arm{*this};

  void run() override {
    const Pose home = arm.kinematics().direct(arm.parameters().home);
    for (const auto& [y, z] : {std::pair{0.1, 0.0}, {0.0, 0.1}, {-0.1, 0.0}}) {
      Pose corner = home;
      corner.translation() += Eigen::Vector3d(0, y, z);
      Move({arm}, {}, CartesianLine{arm, corner, {.speed = 0.2}});
    }
    Move({arm}, {}, JointLine{arm, arm.parameters().home});
  }
};

MRROC_ECP(Triangle)
