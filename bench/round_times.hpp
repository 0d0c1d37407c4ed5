#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace mrroc {

/// The p-th quantile (0..1) of `values`, which are not empty.
template <class Value>
Value quantile(std::vector<Value> values, double p) {
  const auto rank = static_cast<std::ptrdiff_t>(p * static_cast<double>(values.size() - 1) + 0.5);
  std::nth_element(values.begin(), values.begin() + rank, values.end());
  return values[static_cast<std::size_t>(rank)];
}

/// Times of one contestant, round by round, us.
struct RoundTimes {
  std::vector<double> p50;
  std::vector<double> p99;

  /// Adds the round whose exchanges began (and the last one ended) at these times, ns.
  void add(const std::vector<std::int64_t>& stamps) {
    std::vector<double> times;
    times.reserve(stamps.size());
    for (std::size_t i = 1; i < stamps.size(); ++i)
      times.push_back(static_cast<double>(stamps[i] - stamps[i - 1]) * 1e-3);
    p50.push_back(quantile(times, 0.5));
    p99.push_back(quantile(times, 0.99));
  }
};

/// Median over the rounds of `of` / `to`; both were measured under the same load in each round.
inline double median_ratio(const std::vector<double>& of, const std::vector<double>& to) {
  std::vector<double> ratios;
  for (std::size_t i = 0; i < of.size(); ++i) ratios.push_back(of[i] / to[i]);
  return quantile(ratios, 0.5);
}

}  // namespace mrroc
