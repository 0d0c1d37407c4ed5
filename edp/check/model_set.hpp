#pragma once

#include <memory>
#include <utility>

#include "edp/safety/shaft_model.hpp"
#include "mrroc/robot_model.hpp"

namespace mrroc::edp {

/// The models of one robot by their index in its list, and the model of a robot that is not synchronised.
class ModelSet {
 public:
  static constexpr std::uint8_t kShafts = 255;

  /// `models`: at least one.
  explicit ModelSet(RobotModels models) : models_(std::move(models)), shafts_(models_.front()->parameters()) {}
  /// One model, which must outlive this object.
  explicit ModelSet(const RobotModel& model)
      : ModelSet(RobotModels{std::shared_ptr<const RobotModel>(std::shared_ptr<void>(), &model)}) {}

  std::size_t size() const noexcept { return models_.size(); }
  /// `index` below size(), or kShafts.
  const RobotModel& at(std::uint8_t index) const noexcept {
    return index == kShafts ? static_cast<const RobotModel&>(shafts_) : *models_[index];
  }
  const RobotParameters& parameters() const noexcept { return models_.front()->parameters(); }

 private:
  RobotModels models_;
  ShaftModel shafts_;
};

}  // namespace mrroc::edp
