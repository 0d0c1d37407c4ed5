#pragma once

#include "mrroc/condition.hpp"
#include "mrroc/robot.hpp"

namespace mrroc {

/// The path that the tool's measured position has covered since the instruction began is at least `length` (m) long:
/// the sum of the distances from step to step. It also ends closed paths; `Travelled` is the straight distance from the
/// start. Vibration of the tool at rest adds to the sum.
class PathTravelled : public Condition {
 public:
  /// Throws NonFatalError(invalid_argument) unless `length` is finite and above 0.
  PathTravelled(const Robot& robot, double length);

  void start() override;

 protected:
  bool holds() override;

 private:
  const Robot* robot_;
  double length_;
  double way_ = 0;
  Eigen::Vector3d last_ = Eigen::Vector3d::Zero();
};

}  // namespace mrroc
