#include "calibration/common/report.hpp"

#include <array>
#include <charconv>
#include <cstdio>
#include <span>

#include "command/write_file.hpp"
#include "mrroc/errors.hpp"

namespace mrroc::calibration {

namespace {

std::string text_of(const Bound& bound) {
  return bound.what + " " + shown_number(bound.value, 3) + " " + bound.unit + " (at most " +
         shown_number(bound.largest, 3) + " " + bound.unit + ")";
}

/// Not a number is beyond every bound.
bool holds(const Bound& bound) { return bound.value <= bound.largest; }

std::string list_of(const std::vector<Bound>& bounds, bool all) {
  std::string list;
  for (const Bound& bound : bounds)
    if (all || !holds(bound)) list += (list.empty() ? "" : ", ") + text_of(bound);
  return list;
}

}  // namespace

void judge(const std::vector<Bound>& bounds) {
  const std::string beyond = list_of(bounds, false);
  std::printf("%s: %s\n", beyond.empty() ? "accepted" : "refused", list_of(bounds, true).c_str());
  std::fflush(stdout);
  if (!beyond.empty()) throw NonFatalError("the calibration is refused: " + beyond);
}

void write_calibration(const std::filesystem::path& file, const std::string& kind, const std::string& device,
                       const std::vector<Bound>& bounds, const std::string& text) {
  const std::string content = "# Written by `mrroc calibrate " + kind + "` for " + device +
                              ". A deployment names it: [deployment] calibration = [\"" + file.filename().string() +
                              "\"]\n# " + list_of(bounds, true) + "\n" + text;
  command::write_file(file, std::as_bytes(std::span(content)));
  std::printf("wrote %s\n", file.c_str());
  std::fflush(stdout);
}

std::string toml_list(const Eigen::Ref<const Eigen::VectorXd>& values) {
  std::string list;
  for (const double value : values) list += (list.empty() ? "" : ", ") + shown_number(value);
  return "[" + list + "]";
}

std::string shown_number(double value, int digits) {
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, digits);
  return {text.data(), end.ptr};
}

}  // namespace mrroc::calibration
