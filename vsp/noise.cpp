#include "vsp/noise.hpp"

#include <cmath>
#include <numbers>

#include "mrroc/fnv.hpp"

namespace mrroc::vsp {

namespace {

/// The finaliser of SplitMix64 (Steele, Lea, Flood: "Fast splittable pseudorandom number generators", OOPSLA 2014).
std::uint64_t mix(std::uint64_t z) noexcept {
  z += 0x9e3779b97f4a7c15;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
  z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
  return z ^ (z >> 31);
}

/// [0, 1) from the upper 53 bits.
double fraction(std::uint64_t bits) noexcept { return static_cast<double>(bits >> 11) * 0x1p-53; }

}  // namespace

Noise::Noise(std::string_view name) noexcept : seed_(Fnv1a{}.add(name).value()) {}

std::uint64_t Noise::bits(Tick tick, std::uint64_t index) const noexcept { return mix(seed_ ^ mix(tick ^ mix(index))); }

double Noise::uniform(Tick tick, std::uint32_t stream) const noexcept {
  return fraction(bits(tick, 2 * std::uint64_t{stream}));
}

double Noise::normal(Tick tick, std::uint32_t stream) const noexcept {
  const double radius = std::sqrt(-2 * std::log1p(-uniform(tick, stream)));
  return radius * std::cos(2 * std::numbers::pi * fraction(bits(tick, 2 * std::uint64_t{stream} + 1)));
}

}  // namespace mrroc::vsp
