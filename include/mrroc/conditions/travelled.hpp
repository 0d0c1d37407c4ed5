#pragma once

#include "mrroc/condition.hpp"
#include "mrroc/robot.hpp"

namespace mrroc {

/// The tool's measured position is at least `distance` (m) away from where it was when the instruction began.
class Travelled : public Condition {
 public:
  /// Throws NonFatalError(invalid_argument) unless `distance` is finite and above 0.
  Travelled(const Robot& robot, double distance);

  void start() override;

 protected:
  bool holds() override;

 private:
  const Robot* robot_;
  double distance_;
  Eigen::Vector3d origin_ = Eigen::Vector3d::Zero();
};

}  // namespace mrroc
