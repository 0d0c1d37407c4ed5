#pragma once

#include <optional>

#include "config/deployment.hpp"
#include "mrroc/types.hpp"

namespace mrroc::vsp {

/// Six voltages of a transducer's strain gauges, V.
using GaugeVoltages = Eigen::Matrix<double, 6, 1>;

/// Strain gauges of a six-axis transducer and its calibration, as ATI's: the load on the tool's side is
///
///     load = M (gauges - zero)
///
/// the wrench that the tool exerts on the transducer, in the sensor frame and about its origin. M (`calibration`) has
/// the rows force x, y, z (N/V), torque x, y, z (N m/V), one column per gauge; zero (`gauge_zero`) are the voltages
/// without load. A gauge at `gauge_limit` or beyond is saturated: the load is unknown. Any thread; allocates
/// nothing, never throws.
class Gauges {
 public:
  /// Those of a deployment's sensor; nothing when its `calibration` is all zeros. Throws SystemError(configuration) for
  /// a matrix that cannot be inverted (a row of zeros, rows that depend on each other) or a zero at or beyond the
  /// limit.
  static std::optional<Gauges> of(const config::SensorEntry& entry);

  /// N, N m.
  Wrench load(const GaugeVoltages& voltages) const noexcept { return matrix_ * (voltages - zero_); }
  /// Index of the first gauge that is saturated.
  std::optional<int> saturated(const GaugeVoltages& voltages) const noexcept;
  /// The voltages of the gauges under `load`: M^-1 load + zero, cut off at the limit.
  GaugeVoltages voltages(const Wrench& load) const noexcept;
  double limit() const noexcept { return limit_; }  ///< V

 private:
  Eigen::Matrix<double, 6, 6> matrix_;
  Eigen::Matrix<double, 6, 6> inverse_;
  GaugeVoltages zero_;
  double limit_ = 0;
};

}  // namespace mrroc::vsp
