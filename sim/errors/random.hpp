#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "mrroc/types.hpp"
#include "vsp/noise.hpp"

namespace mrroc::sim {

/// The random numbers of one error of one device. They depend on (seed, device, error) alone: another error or another
/// device changes none of them. Any thread.
class ErrorNumbers {
 public:
  ErrorNumbers(std::uint32_t seed, std::string_view device, std::string_view error)
      : noise_(std::to_string(seed) + "/" + std::string(device) + "/" + std::string(error)) {}

  /// Number `index`, uniform within +-`size`.
  double within(double size, std::uint32_t index = 0) const noexcept {
    return size * (2 * noise_.uniform(0, index) - 1);
  }
  /// Number `index`, uniform from 0 to `size`.
  double up_to(double size, std::uint32_t index = 0) const noexcept { return size * noise_.uniform(0, index); }
  /// Of tick `tick`, normal with standard deviation `deviation`.
  double normal(double deviation, Tick tick, std::uint32_t index) const noexcept {
    return deviation * noise_.normal(tick, index);
  }

 private:
  vsp::Noise noise_;
};

}  // namespace mrroc::sim
