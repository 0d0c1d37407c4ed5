#include <cmath>
#include <mrroc/ecp.hpp>
#include <mrroc/robots/conveyor.hpp>
#include <mrroc/sensors/camera.hpp>

#include "hand_over.hpp"
using namespace mrroc;

/// The behaviours of the belt.
struct Belt : ecp::Task {
  Conveyor belt{*this};
  Camera eye{*this, "eye"};

  Belt() {
    eye.set_period(5);
    on<Bring>([this](const Bring&) {
      const When seen{"seen", [this] { return eye.detected() && eye.position().y() > -0.65; }};
      Move({belt}, {eye}, ToolVelocity{belt, {0.1, 0, 0}}.until(seen || Travelled{belt, 2.0}))
          .require("seen", "no bar comes");
      const Eigen::Vector3d at = eye.position(), along = eye.pose().linear().col(0);
      tell(Reach{at.x(), -0.25, -0.13, std::remainder(std::atan2(along.y(), along.x()) - M_PI / 2, M_PI)});
      Move({belt}, {}, JointLine{belt, Conveyor::at(belt.state().joints[0] - 0.25 - at.y()), 0.9});
    });
  }
};

MRROC_ECP(Belt)
