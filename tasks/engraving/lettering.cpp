#include "engraving/lettering.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <fstream>
#include <numbers>
#include <sstream>

#include "config/table.hpp"
#include "mrroc/errors.hpp"

namespace engraving {

namespace {

constexpr double kArcStep = 5 * std::numbers::pi / 180;
constexpr double kLongestArc = 360;                      // degrees
constexpr double kCorner = 20 * std::numbers::pi / 180;  // a turn by more is a corner

/// The points of a `stroke` line behind its first word; none when it is malformed.
Points read_stroke(std::istream& line) {
  Points points;
  double x = 0, y = 0, degrees = 0;
  while (line >> std::ws && !line.eof()) {
    if (line.peek() != 'a') {
      if (!(line >> x >> y)) return {};
      points.emplace_back(x, y);
      continue;
    }
    std::string arc;
    if (points.empty() || !(line >> arc >> x >> y >> degrees) || arc != "arc") return {};
    if (!(std::abs(degrees) <= kLongestArc)) return {};
    const double whole = degrees * std::numbers::pi / 180;
    const int parts = std::max(1, static_cast<int>(std::ceil(std::abs(whole) / kArcStep)));
    const Eigen::Vector2d centre(x, y), spoke = points.back() - centre;
    for (int i = 1; i <= parts; ++i) points.push_back(centre + Eigen::Rotation2Dd(whole * i / parts) * spoke);
  }
  return points;
}

/// Enlarged, shifted, with points on its longer lines, and cut at its corners.
Stroke prepare(const Points& drawn, double height, const Eigen::Vector2d& origin, double spacing) {
  Stroke stroke{{origin + height * drawn.front()}};
  for (std::size_t i = 1; i < drawn.size(); ++i) {
    const Eigen::Vector2d from = drawn[i - 1], way = drawn[i] - from;
    const int parts = std::max(1, static_cast<int>(std::ceil(height * way.norm() / spacing)));
    for (int part = 1; part <= parts; ++part) stroke.back().push_back(origin + height * (from + way * part / parts));
    if (i + 1 == drawn.size()) break;
    const Eigen::Vector2d next = drawn[i + 1] - drawn[i];
    if (way.dot(next) < std::cos(kCorner) * way.norm() * next.norm()) stroke.emplace_back();
  }
  return stroke;
}

void require_inside(const Eigen::Vector2d& point, const Eigen::Vector2d& size, const std::string& text) {
  if (((2 * point).cwiseAbs().array() <= size.array()).all()) return;
  throw mrroc::NonFatalError(mrroc::ErrorCode::invalid_argument,
                             std::string("'")
                                 .append(text + "' does not fit into ")
                                 .append(std::to_string(size.x()) + " x " + std::to_string(size.y()))
                                 .append(" m, expected a smaller height"));
}

}  // namespace

Lettering::Lettering(const std::filesystem::path& file) {
  std::ifstream input(file);
  std::string text;
  int number = 0;
  Glyph* glyph = nullptr;
  const auto require = [&](bool good, const char* expected) {
    if (!good) throw mrroc::config::ConfigurationError(file, number, "", "'" + text + "'", expected);
  };
  require(input.is_open(), "a readable file of letters");
  while (std::getline(input, text)) {
    ++number;
    std::istringstream line(text);
    std::string word;
    char name = 0;
    if (!(line >> word) || word.starts_with('#')) continue;
    if (word == "gap") {
      require(line >> gap_ && gap_ >= 0, "gap NUMBER, at least 0");
    } else if (word == "glyph") {
      double width = 0;
      require(line >> name >> width && width >= 0, "glyph CHARACTER WIDTH");
      glyph = &glyphs_[name];
      glyph->width = width;
    } else {
      const Points points = word == "stroke" ? read_stroke(line) : Points{};
      require(glyph != nullptr && points.size() > 1,
              "stroke X Y, then X Y or arc CX CY DEGREES (up to 360), after a glyph");
      glyph->strokes.push_back(points);
    }
  }
}

std::vector<Stroke> Lettering::strokes(const std::string& text, const Eigen::Vector2d& size, double height,
                                       double spacing) const {
  constexpr double kBlank = 0.5;
  double width = -gap_;
  for (const char c : text) {
    const auto glyph = glyphs_.find(c);
    if (c != ' ' && glyph == glyphs_.end()) {
      throw mrroc::NonFatalError(mrroc::ErrorCode::invalid_argument,
                                 std::string("no strokes for the character '").append(1, c).append("'"));
    }
    width += gap_ + (c == ' ' ? kBlank : glyph->second.width);
  }
  std::vector<Stroke> strokes;
  Eigen::Vector2d origin = -0.5 * height * Eigen::Vector2d(width, 1);
  for (const char c : text) {
    const Glyph glyph = c == ' ' ? Glyph{kBlank, {}} : glyphs_.at(c);
    for (const Points& drawn : glyph.strokes) {
      for (const Eigen::Vector2d& point : drawn) require_inside(origin + height * point, size, text);
      strokes.push_back(prepare(drawn, height, origin, spacing));
    }
    origin.x() += height * (glyph.width + gap_);
  }
  return strokes;
}

}  // namespace engraving
