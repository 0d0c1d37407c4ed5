#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <sstream>
#include <stdexcept>
#include <vector>

#include "faults/fault.hpp"

namespace mrroc::faults {

namespace {

/// A kind of fault as it is written.
struct Row {
  std::string_view word;
  Kind kind;
  Target target;
  bool axis;           ///< an axis must be named, of an EDP
  bool value;          ///< `by X` may be given
  double usual_value;  ///< when it is not
};

constexpr std::array<Row, 16> kRows{{
    {"kill", Kind::kill, Target::any_process, false, false, 0},
    {"halt", Kind::halt, Target::any_process, false, false, 0},
    {"end", Kind::end, Target::any_process, false, false, 0},
    {"fault", Kind::fault, Target::edp, false, false, 0},
    {"silence", Kind::silence, Target::edp_or_vsp, false, false, 0},
    {"unreference", Kind::unreference, Target::edp, false, false, 0},
    {"jump", Kind::jump, Target::edp_or_vsp, true, true, 0.5},
    {"freeze", Kind::freeze, Target::edp_or_vsp, true, false, 0},
    {"nan", Kind::nan, Target::edp_or_vsp, true, false, 0},
    {"overload", Kind::overload, Target::edp, true, true, 3},
    {"disconnect", Kind::disconnect, Target::edp, true, false, 0},
    {"runaway", Kind::runaway, Target::edp, true, false, 0},
    {"lose", Kind::lose, Target::task, false, false, 0},
    {"delay", Kind::delay, Target::task, false, true, 30},
    {"corrupt", Kind::corrupt, Target::task, false, false, 0},
    {"leap", Kind::leap, Target::task, false, true, 0.5},
}};

class Parser {
 public:
  explicit Parser(const std::string& text) : text_(text) {
    std::istringstream stream(text);
    for (std::string word; stream >> word;) words_.push_back(word);
  }

  Fault parse() {
    Fault fault;
    fault.text = text_;
    const Row& row = action();
    fault.kind = row.kind;
    fault.value = row.usual_value;
    target(row, fault);
    const bool edp = role_ == "edp";
    if (row.axis && edp) {
      expect("axis");
      const std::uint64_t axis = whole("an axis, from 1");
      if (axis < 1 || axis > kMaxJoints)
        refuse(std::to_string(axis), "an axis from 1 to " + std::to_string(kMaxJoints));
      fault.axis = static_cast<std::size_t>(axis - 1);
    }
    if (row.value && accept("by")) fault.value = number();
    if (fault.kind == Kind::delay && !(fault.value >= 1 && fault.value <= 1e6))
      refuse(std::to_string(fault.value), "a delay of 1 to 1000000 ticks");
    expect("at");
    when(fault);
    if (row.target != Target::any_process && accept("for")) {
      fault.duration = whole("a number of ticks");
      if (fault.duration == 0) refuse("0", "a number of ticks, from 1");
      expect("ticks");
    }
    if (place_ < words_.size()) refuse(words_[place_], "nothing more");
    return fault;
  }

 private:
  [[noreturn]] void refuse(const std::string& word, const std::string& expected) const {
    std::string text = "the fault \"";
    text.append(text_).append("\": ");
    if (word.empty())
      text.append("it ends");
    else
      text.append("'").append(word).append("'");
    throw std::invalid_argument(text.append(", expected ").append(expected));
  }
  std::string next() { return place_ < words_.size() ? words_[place_++] : ""; }
  bool accept(std::string_view word) {
    if (place_ >= words_.size() || words_[place_] != word) return false;
    ++place_;
    return true;
  }
  void expect(std::string_view word) {
    const std::string got = next();
    if (got != word) refuse(got, std::string{"'"}.append(word).append("'"));
  }
  std::uint64_t whole(const std::string& expected) {
    const std::string word = next();
    std::uint64_t value = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (word.empty() || error != std::errc{} || end != word.data() + word.size()) refuse(word, expected);
    return value;
  }
  double number() {
    const std::string word = next();
    double value = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (word.empty() || error != std::errc{} || end != word.data() + word.size() || !std::isfinite(value))
      refuse(word, "a number");
    return value;
  }

  const Row& action() {
    const std::string word = next();
    std::string known;
    for (const Row& row : kRows) {
      if (row.word == word) return row;
      known += (known.empty() ? "" : ", ") + std::string{row.word};
    }
    refuse(word, "one of " + known);
  }

  void target(const Row& row, Fault& fault) {
    static constexpr std::array<const char*, 4> kExpected = {
        "mp, sim, ecp:ROBOT, edp:ROBOT, drives:ROBOT or vsp:SENSOR", "edp:ROBOT", "edp:ROBOT or vsp:SENSOR",
        "mp or ecp:ROBOT"};
    const std::string expected = kExpected.at(static_cast<std::size_t>(row.target));
    const std::string word = next();
    const std::size_t colon = word.find(':');
    role_.assign(word, 0, colon);
    const std::string name = colon == std::string::npos ? std::string{} : word.substr(colon + 1);
    const bool alone = role_ == "mp" || role_ == "sim";
    const bool of_something = role_ == "ecp" || role_ == "edp" || role_ == "drives" || role_ == "vsp";
    if (!(alone && colon == std::string::npos) && !(of_something && !name.empty())) refuse(word, expected);
    const bool fits =
        row.target == Target::any_process || (row.target == Target::task && (role_ == "mp" || role_ == "ecp")) ||
        (row.target != Target::task && role_ == "edp") || (row.target == Target::edp_or_vsp && role_ == "vsp");
    if (!fits) refuse(word, expected);
    if (alone)
      fault.process = role_;
    else
      fault.process = role_ == "edp" || role_ == "drives" ? name + "_" + role_ : name;
    if (role_ == "mp") fault.counter = "mp";
    if (role_ == "ecp" || role_ == "edp" || role_ == "drives") fault.counter = name;
  }

  void when(Fault& fault) {
    const std::string unit = next();
    if (unit != "tick" && unit != "step") refuse(unit, "'tick' or 'step'");
    fault.at_step = unit == "step";
    fault.when = whole("a " + unit);
    if (fault.at_step && fault.when == 0) refuse("0", "a step, from 1");
    if (fault.at_step && accept("of")) {
      fault.counter = next();
      if (fault.counter.empty()) refuse("", "mp or the name of a robot");
    }
    if (fault.at_step && fault.counter.empty())
      refuse(place_ < words_.size() ? words_[place_] : "", "'of' and mp or a robot");
    if (!fault.at_step) fault.counter.clear();
  }

  const std::string& text_;
  std::vector<std::string> words_;
  std::size_t place_ = 0;
  std::string role_;
};

}  // namespace

Target target_of(Kind kind) noexcept {
  for (const Row& row : kRows)
    if (row.kind == kind) return row.target;
  return Target::any_process;
}

Fault parse_fault(const std::string& text) { return Parser(text).parse(); }

}  // namespace mrroc::faults
