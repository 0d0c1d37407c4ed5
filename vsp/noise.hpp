#pragma once

#include <cstdint>
#include <string_view>

#include "mrroc/types.hpp"

namespace mrroc::vsp {

/// Random numbers that are a function of (name, tick, stream) and of nothing else: the same on every run, whatever was
/// asked before and in whatever order. Streams of one name are independent of each other. Any thread.
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
