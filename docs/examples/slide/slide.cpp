#include "mrroc/robots/slide.hpp"

#include "config/robot_files.hpp"
#include "config/robot_parameters_file.hpp"

namespace mrroc {
namespace {

/// motor = synchro + gear q; the flange is at (q, 0, 0) in the base frame and has its axes.
class SlideModel final : public RobotModel {
 public:
  SlideModel(RobotParameters parameters, double gear) : parameters_(std::move(parameters)), gear_(gear) {}

  const RobotParameters& parameters() const noexcept override { return parameters_; }
  ErrorCode motors_to_joints(const JointVector& motors, JointVector& joints) const noexcept override {
    joints = JointVector::Constant(1, (motors[0] - synchro()) / gear_);
    return ErrorCode::none;
  }
  ErrorCode joints_to_motors(const JointVector& joints, JointVector& motors) const noexcept override {
    motors = JointVector::Constant(1, synchro() + gear_ * joints[0]);
    return ErrorCode::none;
  }
  JointMatrix transmission(const JointVector&) const noexcept override { return JointMatrix::Constant(1, 1, gear_); }
  Pose flange(const JointVector& joints) const noexcept override { return Pose{Eigen::Translation3d(joints[0], 0, 0)}; }
  ErrorCode inverse(const Pose& flange, const JointVector&, JointVector& joints) const noexcept override {
    const double x = flange.translation().x();
    if (!flange.isApprox(Pose{Eigen::Translation3d(x, 0, 0)}, 1e-9)) return ErrorCode::out_of_workspace;
    joints = JointVector::Constant(1, x);
    return ErrorCode::none;
  }
  Jacobian jacobian(const JointVector&, const Eigen::Vector3d&) const noexcept override {
    return Eigen::Matrix<double, 6, 1>::UnitX();
  }

 private:
  double synchro() const noexcept { return parameters_.axes[0].motor_synchro; }
  RobotParameters parameters_;
  double gear_;
};

}  // namespace

RobotModels load_slide(const std::filesystem::path& file) {
  const auto table = config::Table::load(config::parameter_file("slide", file));
  auto parameters = config::read_robot_parameters(table);
  const double gear = table.number("gear", {.min = 1});
  table.finish();
  return {std::make_shared<SlideModel>(std::move(parameters), gear)};
}

}  // namespace mrroc
