#pragma once

#include <cstdint>
#include <string_view>

#include "mrroc/types.hpp"

namespace mrroc::vsp {

/// Random numbers that depend on (name, tick, stream) alone: the same on every run, regardless of earlier requests.
/// Streams of one name are independent of each other. Any thread.
class Noise {
 public:
  /// `name`: of the sensor.
  explicit Noise(std::string_view name) noexcept;

  /// Uniform in [0, 1).
  double uniform(Tick tick, std::uint32_t stream) const noexcept;
  /// Normal, mean 0, standard deviation 1.
  double normal(Tick tick, std::uint32_t stream) const noexcept;

 private:
  std::uint64_t bits(Tick tick, std::uint64_t index) const noexcept;
  std::uint64_t seed_;
};

}  // namespace mrroc::vsp
