#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "core/text_lines.hpp"

namespace engraving {

using Points = std::vector<Eigen::Vector2d>;
/// One stroke without a lift: smooth pieces, each from the end of the one before; corners between them.
using Stroke = std::vector<Points>;

/// Letters of single lines, from a file like capitals.txt.
class Lettering {
 public:
  /// Throws ConfigurationError with file and line. Allowed text around a line: core/text_lines.hpp; `#` begins a
  /// comment at the start of a line and after its second word.
  explicit Lettering(const std::filesystem::path& file);

  /// The strokes of `text`, in the order of writing: capitals `height` m high, the middle of the whole at the origin, x
  /// to the right, y up, a blank half a capital wide. Points are at most `spacing` m apart. Throws
  /// NonFatalError(invalid_argument): a character that is not in the file (the message names it); letters that reach
  /// beyond `size` m, the middle of which is the origin, too.
  std::vector<Stroke> strokes(const std::string& text, const Eigen::Vector2d& size, double height,
                              double spacing) const;

 private:
  struct Glyph {
    double width = 0;
    std::vector<Points> strokes;  ///< in parts of the height: arcs as points 5 degrees apart, lines as their ends
  };
  void read(const std::filesystem::path& file, mrroc::core::TextLines lines);

  double gap_ = 0;
  std::map<char, Glyph> glyphs_;
};

}  // namespace engraving
