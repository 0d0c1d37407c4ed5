#include "kinematics/loaded_model.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/short_number.hpp"
#include "kinematics/decorated_model.hpp"
#include "kinematics/random_numbers.hpp"
#include "mrroc/errors.hpp"

namespace mrroc::kinematics {

namespace {

constexpr int kPostures = 2000;

/// The squares of r_i.
JointVector squared_distances(const RobotModel& model, const Eigen::Vector3d& centre) {
  const auto& axes = model.parameters().axes;
  JointVector largest = JointVector::Zero(std::ssize(axes)), joints = largest;
  std::uint64_t state = 7;
  for (int i = 0; i < kPostures; ++i) {
    for (std::size_t j = 0; j < axes.size(); ++j) {
      const double min = std::isfinite(axes[j].position_min) ? axes[j].position_min : -std::numbers::pi;
      const double max = std::isfinite(axes[j].position_max) ? axes[j].position_max : std::numbers::pi;
      joints[static_cast<Eigen::Index>(j)] = min + next_uniform(state) * (max - min);
    }
    largest = largest.cwiseMax(model.jacobian(joints, centre).topRows<3>().colwise().squaredNorm().transpose());
  }
  return largest;
}

/// 0 to 1; `square`: of the load's distance.
double part_of_acceleration(const AxisParameters& axis, double mass, double square) {
  const double inertia = axis.inertia_max + mass * square;
  if (!std::isfinite(axis.torque_max)) return axis.inertia_max / inertia;
  const double weight = mass * standard_gravity().norm() * std::sqrt(square);
  if (!(weight < axis.torque_max))
    throw SystemError(ErrorCode::configuration, "axis " + axis.name + " cannot bear the load: " + short_number(mass) +
                                                    " kg need " + short_number(weight) +
                                                    " N m or N, expected less than torque_max, " +
                                                    short_number(axis.torque_max));
  return std::min(1.0, (axis.torque_max - weight) / inertia / axis.acceleration_max);
}

RobotParameters loaded(const RobotModel& model, const Load& load) {
  RobotParameters parameters = model.parameters();
  const JointVector squares = squared_distances(model, load.centre);
  for (std::size_t i = 0; i < parameters.axes.size(); ++i) {
    AxisParameters& axis = parameters.axes[i];
    const double part = part_of_acceleration(axis, load.mass, squares[static_cast<Eigen::Index>(i)]);
    axis.acceleration_max *= part;
    axis.jerk_max *= part;
  }
  return parameters;
}

class LoadedModel final : public DecoratedModel {
 public:
  LoadedModel(std::shared_ptr<const RobotModel> model, RobotParameters parameters)
      : DecoratedModel(std::move(model)), parameters_(std::move(parameters)) {}
  const RobotParameters& parameters() const noexcept override { return parameters_; }

 private:
  RobotParameters parameters_;
};

}  // namespace

RobotModels with_load(RobotModels models, const Load& load) {
  if (models.empty() || !(load.mass > 0)) return models;
  // the same limits for every model of the robot
  const RobotParameters parameters = loaded(*models.front(), load);
  for (auto& model : models) model = std::make_shared<LoadedModel>(model, parameters);
  return models;
}

}  // namespace mrroc::kinematics
