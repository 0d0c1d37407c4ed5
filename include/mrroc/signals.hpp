#pragma once

#include <array>
#include <cstdint>

namespace mrroc {

/// The terminals of one robot's controller, inputs or outputs: grippers, valves, lamps and switches are wired to them.
/// The numbers are those of the original.
struct ControllerIo {
  static constexpr int kDigital = 16;
  static constexpr int kAnalog = 8;

  std::uint16_t digital = 0;             ///< bit i: terminal i
  std::array<double, kAnalog> analog{};  ///< in the terminal's own unit, usually V

  /// Digital terminal `i` (0..15).
  constexpr bool on(int i) const noexcept { return ((digital >> i) & 1u) != 0; }
  constexpr void set(int i, bool value) noexcept {
    const auto bit = static_cast<std::uint16_t>(1u << i);
    digital = static_cast<std::uint16_t>(value ? digital | bit : digital & ~bit);
  }

  friend bool operator==(const ControllerIo&, const ControllerIo&) = default;
};

}  // namespace mrroc
