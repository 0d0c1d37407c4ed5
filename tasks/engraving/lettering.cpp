#include "engraving/lettering.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <string_view>

#include "config/table.hpp"
#include "config/text/file_text.hpp"
#include "core/number_text.hpp"
#include "mrroc/errors.hpp"

namespace engraving {

namespace {

constexpr double kArcStep = 5 * std::numbers::pi / 180;
constexpr double kLongestArc = 360;                      // degrees
constexpr double kCorner = 20 * std::numbers::pi / 180;  // a turn by more is a corner

using Words = std::vector<std::string_view>;

/// All of these words as numbers; nothing when one of them is not a number.
std::optional<std::vector<double>> numbers_of(const Words& words, std::size_t from, std::size_t count) {
  std::vector<double> numbers;
  if (from + count > words.size()) return {};
  for (std::size_t i = from; i < from + count; ++i) {
    const auto number = mrroc::core::to_finite(words[i]);
    if (!number) return {};
    numbers.push_back(*number);
  }
  return numbers;
}

/// The points of a `stroke` line; empty when it is malformed.
Points read_stroke(const Words& words) {
  Points points;
  for (std::size_t i = 1; i < words.size();) {
    const bool is_arc = words[i] == "arc";
    const auto numbers = is_arc ? numbers_of(words, i + 1, 3) : numbers_of(words, i, 2);
    if (!numbers || (is_arc && (points.empty() || std::abs((*numbers)[2]) > kLongestArc))) return {};
    i += is_arc ? 4 : 2;
    const Eigen::Vector2d place((*numbers)[0], (*numbers)[1]);
    if (!is_arc) {
      points.push_back(place);
      continue;
    }
    const double whole = (*numbers)[2] * std::numbers::pi / 180;
    const int parts = std::max(1, static_cast<int>(std::ceil(std::abs(whole) / kArcStep)));
    const Eigen::Vector2d spoke = points.back() - place;
    for (int part = 1; part <= parts; ++part)
      points.push_back(place + Eigen::Rotation2Dd(whole * part / parts) * spoke);
  }
  return points;
}

/// Scales and shifts a stroke, adds points to its longer lines, and cuts it at its corners.
Stroke prepare(const Points& drawn, double height, const Eigen::Vector2d& origin, double spacing) {
  Stroke stroke{{origin + height * drawn.front()}};
  for (std::size_t i = 1; i < drawn.size(); ++i) {
    const Eigen::Vector2d& from = drawn[i - 1];
    const Eigen::Vector2d way = drawn[i] - from;
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
  const std::string content = mrroc::config::read_file(file);
  try {
    read(file, mrroc::core::TextLines(content));
  } catch (const mrroc::core::TextError& error) {
    throw mrroc::config::ConfigurationError(file, error.line, "", error.problem, error.expected);
  }
}

void Lettering::read(const std::filesystem::path& file, mrroc::core::TextLines lines) {
  Glyph* glyph = nullptr;
  const auto require = [&](bool good, const char* expected) {
    if (!good)
      throw mrroc::config::ConfigurationError(
          file, lines.number(), "", std::string("'").append(mrroc::core::trimmed(lines.line())).append("'"), expected);
  };
  while (lines.next()) {
    Words words = mrroc::core::words_of(lines.line());
    if (words.empty() || words[0].starts_with('#')) continue;
    // '#' may also be the character of a glyph
    const auto comment = std::find_if(words.begin() + std::min<std::ptrdiff_t>(2, std::ssize(words)), words.end(),
                                      [](std::string_view word) { return word.starts_with('#'); });
    words.erase(comment, words.end());
    if (words[0] == "gap") {
      const auto gap = words.size() == 2 ? numbers_of(words, 1, 1) : std::nullopt;
      require(gap && gap->front() >= 0, "gap NUMBER, at least 0");
      gap_ = gap->front();
    } else if (words[0] == "glyph") {
      const auto width = words.size() == 3 && words[1].size() == 1 ? numbers_of(words, 2, 1) : std::nullopt;
      require(width && width->front() >= 0, "glyph CHARACTER WIDTH");
      glyph = &glyphs_[words[1].front()];
      glyph->width = width->front();
    } else {
      const Points points = words[0] == "stroke" ? read_stroke(words) : Points{};
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
