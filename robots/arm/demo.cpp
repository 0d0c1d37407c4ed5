#include <algorithm>
#include <mrroc/ecp.hpp>
#include <mrroc/robots/arm.hpp>

using namespace mrroc;

/// A tour of the workspace, about home: a square with the tool as it is there, as large as the arm reaches, then each
/// axis alone.
class Tour : public ecp::Task {
  static constexpr double kSide = 0.15;  // m, half of the square
  static constexpr double kTurn = 0.5;   // rad, or a part of the range
  Arm arm{*this};

  void run() override {
    const JointVector home = arm.parameters().home;
    const Pose middle = arm.kinematics().direct(home);
    for (const auto& [y, z] : {std::pair{1, 0}, {1, 1}, {-1, 1}, {-1, 0}}) visit(middle, y * kSide, z * kSide);
    Move({arm}, {}, JointLine{arm, home, 0.9});
    for (Eigen::Index i = 0; i < home.size(); ++i) {
      const AxisParameters& axis = arm.parameters().axes[static_cast<std::size_t>(i)];
      JointVector turned = home;
      turned[i] = std::clamp(home[i] + kTurn, axis.position_min, axis.position_max);
      Move({arm}, {}, JointLine{arm, turned, 0.9});
      Move({arm}, {}, JointLine{arm, home, 0.9});
    }
  }

  /// Half as far when the arm does not reach so far, until it does.
  void visit(const Pose& middle, double y, double z) {
    for (double part = 1; part > 0.01; part /= 2) {
      Pose place = middle;
      place.translation() += part * Eigen::Vector3d(0, y, z);
      try {
        Move({arm}, {}, JointLine{arm, place, 0.9});
        return;
      } catch (const NonFatalError& error) {
        if (error.code() != ErrorCode::out_of_workspace && error.code() != ErrorCode::joint_limit) throw;
      }
    }
  }
};

MRROC_ECP(Tour)
