#pragma once

#include <array>

namespace mrroc {

/// Derivatives at point k of five equally spaced ones, from the values there: exact for polynomials of degree four
/// (Fornberg, Generation of finite difference formulas, 1988). Divide by 12 h, 12 h^2, 2 h^3.
struct DifferenceStencils {
  static constexpr std::size_t kPoints = 5;
  using Row = std::array<double, kPoints>;
  static constexpr std::array<Row, kPoints> kFirst{
      {{-25, 48, -36, 16, -3}, {-3, -10, 18, -6, 1}, {1, -8, 0, 8, -1}, {-1, 6, -18, 10, 3}, {3, -16, 36, -48, 25}}};
  static constexpr std::array<Row, kPoints> kSecond{{{35, -104, 114, -56, 11},
                                                     {11, -20, 6, 4, -1},
                                                     {-1, 16, -30, 16, -1},
                                                     {-1, 4, 6, -20, 11},
                                                     {11, -56, 114, -104, 35}}};
  static constexpr std::array<Row, kPoints> kThird{
      {{-5, 18, -24, 14, -3}, {-3, 10, -12, 6, -1}, {-1, 2, 0, -2, 1}, {1, -6, 12, -10, 3}, {3, -14, 24, -18, 5}}};
};

}  // namespace mrroc
