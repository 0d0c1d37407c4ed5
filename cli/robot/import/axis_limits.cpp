#include "cli/robot/import/axis_limits.hpp"

#include <spdlog/fmt/fmt.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "cli/robot/import/names.hpp"
#include "config/table.hpp"
#include "config/text/message_text.hpp"

namespace mrroc::cli {

namespace {

using config::ConfigurationError;
using config::in_quotes;
using config::number_text;
using edp::Urdf;

constexpr double kGuessedTurn = std::numbers::pi / 2, kGuessedSlide = 0.25;  // rad/s, m/s
constexpr double kEndless = 1e4;                             // rad, m: a position limit beyond counts as missing
constexpr double kFastest = 1e9;                             // of velocity, acceleration, jerk
constexpr double kPerVelocity = 2.5, kPerAcceleration = 10;  // 1/s: in 0.4 s, in 0.1 s

SourcedNumber from_urdf(double value, int line) { return {value, "URDF line " + std::to_string(line)}; }

/// The limits of one arm, and which of them would be guesses.
class LimitFinder {
 public:
  LimitFinder(const Urdf& urdf, const LimitsFile& given, bool accept_guesses, Findings& findings)
      : urdf_(urdf), given_(given), accept_guesses_(accept_guesses), findings_(findings) {}

  AxisLimits limits(const Urdf::Joint& joint, const std::string& name) {
    AxisLimits limits;
    limits.name = name;
    limits.slides = joint.type == Urdf::Type::prismatic;
    limits.position_min = position(joint, name, "position_min", "lower", joint.lower, -1);
    limits.position_max = position(joint, name, "position_max", "upper", joint.upper, 1);
    if (!(limits.position_max.value > limits.position_min.value))
      fail(joint, name, "position_max",
           number_text(limits.position_max.value) + " is not above " + number_text(limits.position_min.value),
           "a range: <limit lower upper>, or position_min and position_max in --limits FILE");
    limits.velocity = velocity(joint, name);
    limits.acceleration = acceleration(joint, name, limits.velocity.value);
    limits.jerk = given_or_guess(joint, name, "jerk_max", limits.acceleration.value * kPerAcceleration,
                                 "acceleration_max / 0.1 s");
    for (const auto& [key, limit] : {std::pair{"velocity_max", &limits.velocity},
                                     {"acceleration_max", &limits.acceleration},
                                     {"jerk_max", &limits.jerk}})
      if (limit->value > kFastest)
        fail(joint, name, key, number_text(limit->value) + " is too large", "at most " + number_text(kFastest));
    limits.torque = given_.find(name, "torque_max");
    if (!limits.torque && joint.effort && *joint.effort > 0) limits.torque = from_urdf(*joint.effort, joint.limit_line);
    return limits;
  }

  /// Refuses what may not be guessed.
  void check() const {
    if (accept_guesses_ || missing_.empty()) return;
    throw ConfigurationError(urdf_.file(), first_line_, first_key_,
                             "is missing; missing limits with guesses in brackets: " + missing_,
                             "them in --limits FILE, or --accept-guesses");
  }

 private:
  SourcedNumber position(const Urdf::Joint& joint, const std::string& name, const std::string& key,
                         const std::string& attribute, const std::optional<double>& in_file, int sign) const {
    if (const auto given = given_.find(name, key)) return *given;
    if (joint.type == Urdf::Type::continuous)
      return {sign * std::numeric_limits<double>::infinity(),
              "URDF line " + std::to_string(joint.line) + ": continuous"};
    if (in_file && std::abs(*in_file) > kEndless)
      return {sign * std::numeric_limits<double>::infinity(),
              "URDF line " + std::to_string(joint.limit_line) + ": " + number_text(*in_file)};
    if (in_file) return from_urdf(*in_file, joint.limit_line);
    fail(joint, name, key, "is missing: no <limit " + attribute + ">",
         "it in the URDF or in --limits FILE, or a continuous joint");
  }

  SourcedNumber acceleration(const Urdf::Joint& joint, const std::string& name, double velocity) {
    const bool in_file = joint.acceleration && *joint.acceleration > 0;
    if (in_file && !given_.find(name, "acceleration_max")) return from_urdf(*joint.acceleration, joint.limit_line);
    return given_or_guess(joint, name, "acceleration_max", velocity * kPerVelocity, "velocity_max / 0.4 s");
  }

  SourcedNumber velocity(const Urdf::Joint& joint, const std::string& name) {
    if (const auto given = given_.find(name, "velocity_max")) return *given;
    if (joint.velocity && *joint.velocity > 0) return from_urdf(*joint.velocity, joint.limit_line);
    const bool slides = joint.type == Urdf::Type::prismatic;
    return guess(joint, name, "velocity_max", slides ? kGuessedSlide : kGuessedTurn,
                 slides ? "0.25 m/s" : "pi/2 rad/s");
  }

  SourcedNumber given_or_guess(const Urdf::Joint& joint, const std::string& name, const std::string& key, double value,
                               const std::string& rule) {
    if (const auto given = given_.find(name, key)) return *given;
    return guess(joint, name, key, value, rule);
  }

  SourcedNumber guess(const Urdf::Joint& joint, const std::string& name, const std::string& key, double value,
                      const std::string& rule) {
    if (missing_.empty()) {
      first_line_ = joint.line;
      first_key_ = key;
    }
    missing_ += (missing_.empty() ? "" : ", ") + name + "." + key + " (" + fmt::format("{:.4g}", value) + ")";
    findings_.guess(key + " = " + rule, name, joint.line);
    return {value, "guessed: " + rule};
  }

  [[noreturn]] void fail(const Urdf::Joint& joint, const std::string& name, const std::string& key,
                         const std::string& problem, const std::string& expected) const {
    throw ConfigurationError(urdf_.file(), joint.limit_line > 0 ? joint.limit_line : joint.line,
                             "joint " + in_quotes(name) + " " + key, problem, expected);
  }

  const Urdf& urdf_;
  const LimitsFile& given_;
  bool accept_guesses_;
  Findings& findings_;
  std::string missing_, first_key_;
  int first_line_ = 0;
};

}  // namespace

std::vector<AxisLimits> limits_of_axes(const Urdf& urdf, const UrdfArm& arm, const LimitsFile& given,
                                       bool accept_guesses, Findings& findings) {
  std::vector<std::string> names;
  for (const Urdf::Joint& joint : arm.axes) names.push_back(joint.name);
  names = unique_names(names, kNameLength);
  given.check_names(names);
  LimitFinder finder(urdf, given, accept_guesses, findings);
  std::vector<AxisLimits> limits;
  for (std::size_t i = 0; i < names.size(); ++i) limits.push_back(finder.limits(arm.axes[i], names[i]));
  finder.check();
  return limits;
}

}  // namespace mrroc::cli
