#include <mrroc/ecp.hpp>
#include <mrroc/robots/irb6.hpp>
#include <mrroc/sensors/camera.hpp>

using namespace mrroc;

/// Two things lie on a table. A camera on the arm's flange finds the blue part, one beside the table the marker; the
/// arm points at both.
class Pointing : public ecp::Task {
  Irb6 arm{*this};
  Camera eye{*this, "eye"};
  Camera lookout{*this, "lookout"};

  void point_at(const Camera& camera) {
    const Eigen::Vector3d at = camera.position();  // in the arm's base frame
    Move({arm}, {}, JointLine{arm, Irb6::tool_down(at.x(), at.y(), at.z() + 0.03), 0.9});
  }

  /// The scene has them here, in the arm's base frame; a real task has no such values.
  static void check(const Camera& camera, const Eigen::Vector3d& where) {
    const double error = (camera.position() - where).norm();
    if (error > 0.002) throw NonFatalError{camera.name() + " is wrong by " + std::to_string(error) + " m"};
  }

  void run() override {
    Move({arm}, {}, JointLine{arm, Irb6::tool_down(0.65, 0.0, 0.1), 0.9});
    Wait({arm}, {eye}, Seen{eye, 0.002});
    check(eye, {0.70, 0.08, -0.096});
    point_at(eye);
    Wait({arm}, {lookout}, Seen{lookout});
    check(lookout, {0.76, -0.12, -0.098});
    point_at(lookout);
    Move({arm}, {}, JointLine{arm, arm.parameters().home, 0.9});
  }
};

MRROC_ECP(Pointing)
