#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <cmath>
#include <cstdint>

namespace mrroc::clock {

/// Counts durations (ns, >= 0) in bins of a fixed relative width: 16 bins per power of two, so that a percentile is at
/// most 1/16 too large. No allocation. One thread adds, any thread reads.
class Histogram {
 public:
  void add(std::int64_t ns) noexcept {
    const auto value = static_cast<std::uint64_t>(ns < 0 ? 0 : ns);
    increment(bins_[bin(value)]);
    increment(count_);
    if (value > max_.load(std::memory_order_relaxed)) max_.store(value, std::memory_order_relaxed);
  }

  std::uint64_t count() const noexcept { return count_.load(std::memory_order_relaxed); }
  /// Largest value, ns; 0 when empty.
  std::uint64_t max() const noexcept { return max_.load(std::memory_order_relaxed); }
  /// Upper edge (ns) of the bin below which the fraction `p` (0..1] of the values lies, not above max(); 0 when empty.
  std::uint64_t percentile(double p) const noexcept {
    const auto wanted = static_cast<std::uint64_t>(std::ceil(p * static_cast<double>(count())));
    std::uint64_t below = 0;
    for (std::size_t i = 0; i < kBins; ++i) {
      below += bins_[i].load(std::memory_order_relaxed);
      if (below >= wanted && below > 0) return std::min(upper_edge(i), max());
    }
    return max();
  }

 private:
  static constexpr std::uint64_t kPerOctave = 16;
  static constexpr int kOctaves = 40;  // 2^40 ns are 18 minutes; longer ones go to the last bin
  static constexpr std::size_t kBins = kPerOctave * (kOctaves - 3);

  // values below 16 have a bin each; above, the four bits after the leading one choose the bin
  static std::size_t bin(std::uint64_t value) noexcept {
    if (value < kPerOctave) return value;
    const int shift = static_cast<int>(std::bit_width(value)) - 5;
    const std::uint64_t index = kPerOctave * static_cast<std::uint64_t>(shift) + (value >> shift);
    return index < kBins ? index : kBins - 1;
  }
  static std::uint64_t upper_edge(std::size_t bin) noexcept {
    if (bin < 2 * kPerOctave) return bin;
    const std::uint64_t shift = bin / kPerOctave - 1;
    return ((bin % kPerOctave + kPerOctave + 1) << shift) - 1;
  }
  static void increment(std::atomic<std::uint64_t>& counter) noexcept {
    counter.store(counter.load(std::memory_order_relaxed) + 1, std::memory_order_relaxed);
  }

  std::array<std::atomic<std::uint64_t>, kBins> bins_{};
  std::atomic<std::uint64_t> count_{0};
  std::atomic<std::uint64_t> max_{0};
};

}  // namespace mrroc::clock
