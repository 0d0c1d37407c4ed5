#include "tasks/engraving/board.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <vector>

namespace mrroc::test {
namespace {

TEST(Board, HeightFieldEqualsTheFormula) {
  std::ifstream file(std::filesystem::path(MRROC_SOURCE_DIR) / "tasks/engraving/board.hfield", std::ios::binary);
  std::int32_t rows = 0, columns = 0;
  file.read(reinterpret_cast<char*>(&rows), 4);
  file.read(reinterpret_cast<char*>(&columns), 4);
  ASSERT_EQ(rows, 101);
  ASSERT_EQ(columns, 51);
  std::vector<float> heights(static_cast<std::size_t>(rows) * static_cast<std::size_t>(columns));
  file.read(reinterpret_cast<char*>(heights.data()), static_cast<std::streamsize>(4 * heights.size()));
  ASSERT_TRUE(file.good());
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const double u = 0.1 - 0.002 * row, v = -0.05 + 0.002 * column;
      ASSERT_NEAR(heights[static_cast<std::size_t>(row * columns + column)], board_height(u, v), 1e-8);
    }
  }
  // the scale in engraving.xml: MuJoCo scales the heights to 0..1
  const auto [lowest, highest] = std::minmax_element(heights.begin(), heights.end());
  EXPECT_NEAR(*highest - *lowest, 0.009828575, 1e-8);
  EXPECT_NEAR(*lowest, 0.044992132 - (0.6 - 0.551), 1e-8);
}

TEST(Board, FlatFacetsOf2MillimetresStayWithin4MicrometresOfIt) {
  double worst = 0;
  for (double u = -0.099; u < 0.098; u += 0.002) {
    for (double v = -0.049; v < 0.048; v += 0.002) {
      const double corners = board_height(u - 0.001, v) + board_height(u + 0.001, v);
      const double across = board_height(u, v - 0.001) + board_height(u, v + 0.001);
      worst = std::max({worst, std::abs(corners / 2 - board_height(u, v)), std::abs(across / 2 - board_height(u, v))});
    }
  }
  EXPECT_LT(worst, 4e-6);
}

}  // namespace
}  // namespace mrroc::test
