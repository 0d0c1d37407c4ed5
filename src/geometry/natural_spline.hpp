#pragma once

#include <vector>

#include "mrroc/robot_parameters.hpp"

namespace mrroc {

/// The natural cubic spline through joint positions at given times: twice continuously differentiable, its second
/// derivative 0 at both ends. Any thread; only the constructor allocates.
class NaturalSpline {
 public:
  struct Sample {
    JointVector position, first, second, third;  ///< and derivatives with respect to time
  };

  NaturalSpline() = default;
  /// At least two points of the same size; strictly increasing times.
  NaturalSpline(std::vector<double> times, std::vector<JointVector> positions);

  double begin() const noexcept { return times_.front(); }
  double end() const noexcept { return times_.back(); }
  /// At `time`, of the part that it lies in; before the begin and after the end, of the nearest one.
  Sample at(double time) const noexcept;

 private:
  std::vector<double> times_;
  std::vector<JointVector> positions_;
  std::vector<JointVector> curvatures_;  ///< second derivatives at the points
};

}  // namespace mrroc
