#include "sensors/force_torque/gauges.hpp"

#include <Eigen/LU>
#include <Eigen/SVD>
#include <cmath>
#include <string>

#include "vsp/parameters.hpp"

namespace mrroc::vsp {

namespace {

using Matrix6 = Eigen::Matrix<double, 6, 6>;
using Matrix6InFileOrder = Eigen::Matrix<double, 6, 6, Eigen::RowMajor>;

/// Of the rows scaled to length 1: a transducer's is some 0.01 to 1.
constexpr double kSmallestReciprocalCondition = 1e-6;

template <typename Fixed>
Fixed fixed(const config::SensorEntry& entry, const std::string& key) {
  const auto found = entry.numbers.find(key);
  const std::size_t count = found == entry.numbers.end() ? 0 : found->second.size();
  if (count != std::size_t{Fixed::SizeAtCompileTime}) {
    refuse(entry, key, std::to_string(count).append(" numbers"), std::to_string(int{Fixed::SizeAtCompileTime}));
  }
  return Fixed{found->second.data()};
}

/// Newtons and newton metres differ in size: only the directions of the rows count.
double reciprocal_condition(const Matrix6& matrix) {
  if (matrix.rowwise().norm().minCoeff() == 0) return 0;
  const Eigen::Matrix<double, 6, 1> singular =
      Eigen::JacobiSVD<Matrix6>(matrix.rowwise().normalized()).singularValues();
  return singular.minCoeff() / singular.maxCoeff();
}

}  // namespace

std::optional<Gauges> Gauges::of(const config::SensorEntry& entry) {
  Gauges gauges;
  gauges.matrix_ = fixed<Matrix6InFileOrder>(entry, "calibration");
  gauges.zero_ = fixed<GaugeVoltages>(entry, "gauge_zero");
  gauges.limit_ = number(entry, "gauge_limit");
  if (gauges.matrix_.isZero(0)) return std::nullopt;
  if (!(reciprocal_condition(gauges.matrix_) > kSmallestReciprocalCondition)) {
    refuse(entry, "calibration", "a matrix that cannot be inverted",
           "6 independent rows: force x, y, z (N/V), torque x, y, z (N m/V)");
  }
  if (const std::optional<int> gauge = gauges.saturated(gauges.zero_)) {
    refuse(entry, std::string("gauge_zero[").append(std::to_string(*gauge)).append("]"),
           std::to_string(gauges.zero_[*gauge]).append(" V"),
           std::string("within gauge_limit, ").append(std::to_string(gauges.limit_)).append(" V"));
  }
  gauges.inverse_ = gauges.matrix_.inverse();
  return gauges;
}

std::optional<int> Gauges::saturated(const GaugeVoltages& voltages) const noexcept {
  for (int i = 0; i < 6; ++i) {
    if (std::abs(voltages[i]) >= limit_) return i;
  }
  return std::nullopt;
}

GaugeVoltages Gauges::voltages(const Wrench& load) const noexcept {
  return (inverse_ * load + zero_).cwiseMax(-limit_).cwiseMin(limit_);
}

}  // namespace mrroc::vsp
