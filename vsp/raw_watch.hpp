#pragma once

#include <array>
#include <vector>

#include "config/deployment.hpp"
#include "mrroc/sensor_link.hpp"
#include "vsp/raw_reading.hpp"

namespace mrroc::vsp {

/// Detects hardware that is broken although it answers, as far as the deployment requests it:
///
/// - frozen: all raw values have been the same, bit for bit, for `frozen_after` s of at least three readings;
/// - noisy: the noise of a raw value is above its `noise_max`. Its standard deviation is estimated over the last
///   kWindow readings from their second differences, s^2 = mean (r_k - 2 r_k-1 + r_k-2)^2 / 6, to which a signal that
///   is straight over three readings does not contribute.
///
/// The VSP's thread; allocates nothing after construction.
class RawWatch {
 public:
  static constexpr std::size_t kWindow = 64;

  RawWatch() = default;
  /// `servo_period` in s. Throws SystemError(configuration) when `noise_max` has not one number per raw channel.
  RawWatch(const config::SensorEntry& entry, const std::vector<config::Channel>& raw_channels, double servo_period);

  /// Checks a complete and finite reading, later than the one before; `v` becomes a HardwareError(sensor_hardware)
  /// when it is frozen or noisy.
  void check(const RawReading& r, SensorReading& v) noexcept;

 private:
  void check_frozen(const RawReading& r, SensorReading& v) noexcept;
  void check_noisy(const RawReading& r, SensorReading& v) noexcept;

  std::vector<config::Channel> channels_;
  std::vector<double> noise_max_;
  double frozen_after_ = 0;  ///< ticks
  RawReading last_, before_last_;
  std::size_t seen_ = 0;
  std::size_t same_ = 0;  ///< readings since the values changed
  Tick changed_ = 0;
  std::array<std::array<double, kWindow>, kMaxRawValues> squares_{};  ///< of the second differences
};

}  // namespace mrroc::vsp
