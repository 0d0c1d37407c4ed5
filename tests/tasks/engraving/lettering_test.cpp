#include "engraving/lettering.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <fstream>

#include "config/table.hpp"
#include "language/property.hpp"
#include "mrroc/errors.hpp"
#include "mrroc/testing/scratch_folder.hpp"

namespace engraving {
namespace {

using Eigen::Vector2d;

const Vector2d kLarge(100, 100);

Lettering capitals() { return Lettering(std::filesystem::path(MRROC_SOURCE_DIR) / "tasks/engraving/capitals.txt"); }

/// Lettering from a file with this text; the file is read when this returns.
Lettering letters(const std::string& text) {
  const mrroc::task_test::ScratchFolder folder;
  return Lettering(folder.write("letters.txt", text));
}

TEST(Lettering, EveryTextIsWrittenInOneRowWithoutGapsInItsStrokes) {
  const Lettering font = capitals();
  mrroc::fakes::check_property(100, [&font] {
    const auto text = *rc::gen::nonEmpty(
        rc::gen::container<std::string>(rc::gen::elementOf(std::string("ABCDEFGHIJKLMNOPQRSTUVWXYZ+- "))));
    const double height = *rc::gen::elementOf(std::vector<double>{0.01, 0.026, 1.0});
    const double spacing = 0.1 * height;
    for (const Stroke& stroke : font.strokes(text, kLarge, height, spacing)) {
      Vector2d last = stroke.at(0).at(0);
      for (const Points& piece : stroke) {
        RC_ASSERT(!piece.empty());
        for (std::size_t i = 0; i < piece.size(); ++i) {
          RC_ASSERT((piece[i] - last).norm() < 1.001 * spacing);
          RC_ASSERT(std::abs(piece[i].y()) < 0.57 * height);
          last = piece[i];
        }
      }
    }
  });
}

TEST(Lettering, PiecesAreSmoothAndMeetInCorners) {
  const auto cosine = [](const Vector2d& a, const Vector2d& b) { return a.normalized().dot(b.normalized()); };
  for (const Stroke& stroke : capitals().strokes("MRROC++", kLarge, 0.026, 0.002)) {
    Points all;
    std::vector<bool> corner;
    for (const Points& piece : stroke) {
      for (std::size_t i = 0; i < piece.size(); ++i) {
        all.push_back(piece[i]);
        corner.push_back(i + 1 == piece.size());
      }
    }
    for (std::size_t i = 1; i + 1 < all.size(); ++i) {
      const double turn = cosine(all[i] - all[i - 1], all[i + 1] - all[i]);
      if (corner[i]) {
        EXPECT_LT(turn, 0.94) << all[i].transpose();
      } else {
        EXPECT_GT(turn, 0.99) << all[i].transpose();
      }
    }
  }
}

TEST(Lettering, TheInscriptionHasElevenStrokesOfSixteenPieces) {
  const auto strokes = capitals().strokes("MRROC++", kLarge, 0.026, 0.002);
  std::size_t pieces = 0;
  for (const Stroke& stroke : strokes) pieces += stroke.size();
  EXPECT_EQ(strokes.size(), 11u);
  EXPECT_EQ(pieces, 16u);
}

TEST(Lettering, LinesAndArcsHaveTheirPositionsInTheFile) {
  const auto strokes = letters("gap 0.5\nglyph x 1\nstroke 0 0  1 0  arc 1 0.5 180\n").strokes("xx", kLarge, 2, 10);
  ASSERT_EQ(strokes.size(), 2u);
  // the text is 2 * (1 + 0.5 + 1) wide
  EXPECT_LT((strokes[0][0].front() - Vector2d(-2.5, -1)).norm(), 1e-12);
  EXPECT_LT((strokes[0][0].back() - Vector2d(-0.5, 1)).norm(), 1e-12);
  EXPECT_LT((strokes[1][0].front() - Vector2d(0.5, -1)).norm(), 1e-12);
  for (std::size_t i = 1; i < strokes[0][0].size(); ++i)
    EXPECT_NEAR((strokes[0][0][i] - Vector2d(-0.5, 0)).norm(), 1, 1e-12);
}

TEST(Lettering, RefusesUnwritableTexts) {
  try {
    capitals().strokes("AB*", kLarge, 1, 1);
    FAIL();
  } catch (const mrroc::NonFatalError& error) {
    EXPECT_NE(std::string(error.what()).find("character '*'"), std::string::npos) << error.what();
  }
  EXPECT_THROW(capitals().strokes("MRROC++", {0.1, 0.04}, 0.026, 0.002), mrroc::NonFatalError);
  EXPECT_THROW(capitals().strokes("MRROC++", {0.18, 0.02}, 0.026, 0.002), mrroc::NonFatalError);
}

TEST(Lettering, AcceptsAdditionsOfEditors) {
  for (const char* const text :
       {"\xEF\xBB\xBFgap 0\nglyph A 1\nstroke 0 0 1 1\n", "gap 0\r\nglyph A 1\r\nstroke 0 0 1 1\r\n",
        "gap +0 \t# none\n\nglyph A 1. # wide\nstroke 0 0 1 1 # slanted", "glyph # 1\nglyph A 1\nstroke\t0 0 +1 1e0"})
    EXPECT_EQ(letters(text).strokes("A", kLarge, 1, 10).size(), 1u) << text;
}

TEST(Lettering, ErrorInTheFileIsReportedWithItsLine) {
  for (const char* wrong :
       {"gap -1\n", "glyph A\n", "stroke 0 0 1 1\n", "glyph A 1\nstroke 0 0\n", "glyph A 1\nstroke arc 0 0 90\n",
        "glyph A 1\nstroke 0 0 arc 1 1\n", "letter A 1\n", "glyph A 1\nstroke 0 0 1\n",
        "glyph A 1\nstroke 0 0 arch 1 1 90\n", "glyph A 1\nstroke 0 0 1 0,5\n", "gap 0.2 0.3\n", "glyph A nan\n",
        "glyph A 1\nstroke 0 0 arc 1 1 1e30\n"}) {
    try {
      letters(wrong);
      ADD_FAILURE() << wrong;
    } catch (const mrroc::config::ConfigurationError& error) {
      const std::string line = std::count(wrong, wrong + std::strlen(wrong), '\n') == 2 ? ":2:" : ":1:";
      EXPECT_NE(std::string(error.what()).find(line), std::string::npos) << error.what();
    }
  }
  EXPECT_THROW(Lettering("/nowhere/letters.txt"), mrroc::config::ConfigurationError);
}

}  // namespace
}  // namespace engraving
