#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <stdexcept>
#include <vector>

#include "core/number_text.hpp"
#include "core/shown_text.hpp"
#include "faults/fault.hpp"
#include "mrroc/signals.hpp"

namespace mrroc::faults {

namespace {

// the targets of a fault
constexpr unsigned kMp = 1, kSim = 2, kEcp = 4, kEdp = 8, kDrives = 16, kVsp = 32, kIo = 64;
constexpr int kMaxNode = 127;  // of a CAN bus
constexpr unsigned kTask = kMp | kEcp, kAny = kMp | kSim | kEcp | kEdp | kDrives | kVsp;

struct Role {
  unsigned bit;
  std::string_view word;
  std::string_view of;  ///< what its name is one of; empty: there is one such process
};

constexpr std::array<Role, 7> kRoles{{{kMp, "mp", ""},
                                      {kSim, "sim", ""},
                                      {kEcp, "ecp", "ROBOT"},
                                      {kEdp, "edp", "ROBOT"},
                                      {kDrives, "drives", "ROBOT"},
                                      {kIo, "io", "ROBOT"},
                                      {kVsp, "vsp", "SENSOR"}}};

/// The text form of a kind of fault.
struct Row {
  std::string_view word;
  Kind kind;
  unsigned targets;
  unsigned of_axis = 0;    ///< those of them that need an axis
  bool value = false;      ///< `by X` may be given
  double usual_value = 0;  ///< when it is not
};

constexpr std::array<Row, 20> kRows{{
    {"kill", Kind::kill, kAny},
    {"halt", Kind::halt, kAny},
    {"end", Kind::end, kAny},
    {"fault", Kind::fault, kEdp | kDrives | kIo, kDrives},
    {"silence", Kind::silence, kEdp | kDrives | kIo | kVsp, kDrives},
    {"unreference", Kind::unreference, kEdp},
    {"jump", Kind::jump, kEdp | kVsp, kEdp, true, 0.5},
    {"freeze", Kind::freeze, kEdp | kDrives | kVsp, kEdp | kDrives},
    {"nan", Kind::nan, kEdp | kVsp, kEdp},
    {"overload", Kind::overload, kEdp, kEdp, true, 3},
    {"disconnect", Kind::disconnect, kEdp, kEdp},
    {"runaway", Kind::runaway, kEdp, kEdp},
    {"restart", Kind::restart, kDrives | kIo, kDrives},
    {"hush", Kind::hush, kDrives | kIo, kDrives},
    {"press", Kind::press, kDrives, kDrives},
    {"stick", Kind::stick, kIo},
    {"lose", Kind::lose, kTask},
    {"delay", Kind::delay, kTask, 0, true, 30},
    {"corrupt", Kind::corrupt, kTask | kDrives, kDrives},
    {"leap", Kind::leap, kTask, 0, true, 0.5},
}};

/// "edp:ROBOT, drives:ROBOT or vsp:SENSOR".
std::string names(unsigned targets) {
  std::vector<std::string> words;
  for (const Role& role : kRoles)
    if ((role.bit & targets) != 0)
      words.push_back(std::string{role.word}.append(role.of.empty() ? "" : ":").append(role.of));
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i)
    text.append(i == 0 ? "" : i + 1 == words.size() ? " or " : ", ").append(words[i]);
  return text;
}

class Parser {
 public:
  explicit Parser(const std::string& text) : text_(text) {
    std::istringstream stream(text);
    for (std::string word; stream >> word;) words_.push_back(word);
  }

  InjectedFault parse() {
    InjectedFault fault;
    fault.text = text_;
    const Row& row = action();
    fault.kind = row.kind;
    fault.value = row.usual_value;
    target(row, fault);
    if ((row.of_axis & role_) != 0) {
      expect("axis");
      const std::uint64_t axis = whole("an axis, from 1");
      if (axis < 1 || axis > kMaxJoints)
        refuse(std::to_string(axis), "an axis from 1 to " + std::to_string(kMaxJoints));
      fault.axis = static_cast<std::size_t>(axis - 1);
    }
    if (role_ == kIo) io_part(fault);
    if (row.value && accept("by")) fault.value = number();
    if (fault.kind == Kind::delay && !(fault.value >= 1 && fault.value <= 1e6))
      refuse(std::to_string(fault.value), "a delay of 1 to 1000000 ticks");
    expect("at");
    when(fault);
    if (!is_signal(fault.kind) && accept("for")) {
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
    throw std::invalid_argument(core::shown(text.append(", expected ").append(expected)));
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
    const auto value = core::to_whole<std::uint64_t>(word);
    if (!value) refuse(word, expected);
    return *value;
  }
  int whole(const std::string& expected, int least, int most) {
    const std::string word = next();
    const auto value = core::to_whole<int>(word);
    if (!value || *value < least || *value > most)
      refuse(word, expected + " from " + std::to_string(least) + " to " + std::to_string(most));
    return *value;
  }
  double number() {
    const std::string word = next();
    const auto value = core::to_finite(word);
    if (!value) refuse(word, "a number");
    return *value;
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

  void target(const Row& row, InjectedFault& fault) {
    const std::string word = next();
    const std::size_t colon = word.find(':');
    const std::string name = colon == std::string::npos ? std::string{} : word.substr(colon + 1);
    const std::string first = word.substr(0, colon);
    const auto* const role = std::find_if(kRoles.begin(), kRoles.end(), [&](const Role& each) {
      return each.word == first && (each.of.empty() ? colon == std::string::npos : !name.empty());
    });
    if (role == kRoles.end() || (role->bit & row.targets) == 0) refuse(word, names(row.targets));
    role_ = role->bit;
    fault.process = role->of.empty() ? first : name;
    if (role_ == kEdp) fault.process.append("_edp");
    if ((role_ & (kDrives | kIo)) != 0) fault.process.append("_drives");
    if (role_ == kMp) fault.counter = "mp";
    if ((role_ & (kEcp | kEdp | kDrives | kIo)) != 0) fault.counter = name;
  }

  void io_part(InjectedFault& fault) {
    if (fault.kind != Kind::stick) {
      expect("node");
      fault.io = IoPart::node;
      fault.io_number = whole("a node", 1, kMaxNode);
      return;
    }
    const std::string word = next();
    if (word != "input" && word != "analog") refuse(word, "'input' or 'analog'");
    const bool digital = word == "input";
    fault.io = digital ? IoPart::digital_input : IoPart::analog_input;
    fault.io_number = whole("an input", 0, (digital ? ControllerIo::kDigital : ControllerIo::kAnalog) - 1);
    expect("to");
    fault.value = digital ? whole("a state", 0, 1) : number();
  }

  void when(InjectedFault& fault) {
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
  unsigned role_ = 0;  ///< of the target
};

}  // namespace

bool is_signal(Kind kind) noexcept { return kind == Kind::kill || kind == Kind::halt || kind == Kind::end; }

InjectedFault parse_fault(const std::string& text) { return Parser(text).parse(); }

}  // namespace mrroc::faults
