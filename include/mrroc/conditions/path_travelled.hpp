#pragma once

#include "mrroc/condition.hpp"
#include "mrroc/robot.hpp"

namespace mrroc {

/// The way that the tool's measured position has gone since the instruction began is at least `length` (m) long: the
/// sum of the distances from step to step. Ends what comes back to where it began; `Travelled` is the straight distance
/// from there. A tool that trembles at rest adds to it.
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
