#include "vsp/raw_watch.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "vsp/parameters.hpp"
#include "vsp/reading_error.hpp"

namespace mrroc::vsp {

RawWatch::RawWatch(const config::SensorEntry& entry, const std::vector<config::Channel>& raw_channels,
                   double servo_period)
    : channels_(raw_channels), noise_max_(entry.noise_max), frozen_after_(entry.frozen_after / servo_period) {
  if (!noise_max_.empty() && noise_max_.size() != channels_.size()) {
    refuse(entry, "noise_max", std::to_string(noise_max_.size()) + " numbers",
           "one for each of the " + std::to_string(channels_.size()) + " raw channels");
  }
}

void RawWatch::check(const RawReading& r, SensorReading& v) noexcept {
  if (seen_ > 0 && r.tick <= last_.tick) return;
  if (frozen_after_ > 0) check_frozen(r, v);
  if (!noise_max_.empty()) check_noisy(r, v);
  before_last_ = last_;
  last_ = r;
  ++seen_;
}

void RawWatch::check_frozen(const RawReading& r, SensorReading& v) noexcept {
  if (seen_ == 0 || !std::equal(r.values.begin(), r.values.begin() + r.count, last_.values.begin())) {
    same_ = 0;
    changed_ = r.tick;
  }
  ++same_;
  const auto ticks = static_cast<double>(r.tick - changed_);
  if (same_ < 3 || ticks < frozen_after_) return;
  report(v, ErrorClass::hardware, ErrorCode::sensor_hardware, "frozen: %s has been %g for %.0f ticks",
         channels_[0].name.c_str(), r.values[0], ticks);
}

void RawWatch::check_noisy(const RawReading& r, SensorReading& v) noexcept {
  if (seen_ < 2) return;
  for (std::size_t i = 0; i < noise_max_.size(); ++i) {
    const double difference = r.values[i] - 2 * last_.values[i] + before_last_.values[i];
    squares_[i][seen_ % kWindow] = difference * difference;
    if (noise_max_[i] == 0 || seen_ < kWindow + 1) continue;
    const double sum = std::accumulate(squares_[i].begin(), squares_[i].end(), 0.0);
    const double deviation = std::sqrt(sum / (6 * static_cast<double>(kWindow)));
    if (deviation <= noise_max_[i]) continue;
    return report(v, ErrorClass::hardware, ErrorCode::sensor_hardware,
                  "noisy: %s has a standard deviation of %g %s, expected at most %g", channels_[i].name.c_str(),
                  deviation, channels_[i].unit.c_str(), noise_max_[i]);
  }
}

}  // namespace mrroc::vsp
