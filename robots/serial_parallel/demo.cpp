#include <mrroc/ecp.hpp>
#include <mrroc/robots/serial_parallel.hpp>
#include <numbers>

using namespace mrroc;

/// A tour over the board: its corners, a star above it, the spindle tilted about its tip, home.
class Tour : public ecp::Task {
  SerialParallel machine{*this};

  void go(const Pose& tip) { Move({machine}, {}, JointLine{machine, tip, 0.8}); }

  void run() override {
    constexpr double kCentre = 0.05, kAbove = -0.53, kClose = -0.54;  // m, of the board's centre x and of z
    for (const auto& [x, y] : {std::pair{-0.1, -0.1}, {-0.1, 0.1}, {0.1, 0.1}, {0.1, -0.1}}) {
      go(SerialParallel::tool_down(kCentre + x, y, kAbove));
    }
    for (int corner = 0; corner <= 5; ++corner) {
      const double angle = corner * 0.8 * std::numbers::pi;
      go(SerialParallel::tool_down(kCentre + 0.08 * std::cos(angle), 0.08 * std::sin(angle), kClose));
    }
    for (const double tilt : {0.3, -0.3}) {
      go(SerialParallel::tool_down(kCentre, 0, kAbove) * Eigen::AngleAxisd(tilt, Eigen::Vector3d::UnitX()));
    }
    Move({machine}, {}, JointLine{machine, machine.parameters().home});
  }
};

MRROC_ECP(Tour)
