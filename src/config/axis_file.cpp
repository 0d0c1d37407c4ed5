#include "config/axis_file.hpp"

#include <algorithm>
#include <array>
#include <numbers>
#include <string>
#include <vector>

#include "config/text/message_text.hpp"

namespace mrroc::config {

namespace {

constexpr double kUsualStuck = 0.08;      // of the maximum following error; up to 0.022 occurs, with or without contact
constexpr Range kBandwidth{0.5, 200};     // Hz
constexpr Range kInertia{1e-12, 1e12};    // kg m2, kg
constexpr double kUsualCorrection = 0.2;  // position gain of velocity interfaces, of the bandwidth

double not_negative_or(const Table& table, std::string_view key, double fallback) {
  const double value = table.number_or(key, fallback);
  if (!(value >= 0)) table.fail(key, number_text(value) + " is negative", "0 or a number above 0");
  return value;
}

/// `max_key`, which must lie above the value of `min_key`.
double above(const Table& table, std::string_view max_key, double min, const std::string& min_key) {
  const double max = table.limit(max_key);
  if (!(max > min)) {
    table.fail(max_key, number_text(max) + " is not above " + min_key, "a number above " + number_text(min));
  }
  return max;
}

/// Keys that drives with a controller of their own may leave out: a number that is missing is the fallback there.
class DriveKeys {
 public:
  DriveKeys(const Table& table, const DriveParameters& drives)
      : table_(table), optional_(drives.regulate_themselves()), bandwidth_(optional_ ? 0 : drives.bandwidth) {}

  bool left_out(std::string_view key) const { return optional_ && !table_.has(key); }
  double positive(std::string_view key, double fallback) const {
    return left_out(key) ? fallback : config::positive(table_, key);
  }
  double number(std::string_view key, double fallback) const { return left_out(key) ? fallback : table_.number(key); }
  /// Hz; 0: no regulator is to be designed.
  double bandwidth() const { return bandwidth_; }

 private:
  const Table& table_;
  bool optional_;
  double bandwidth_;
};

void read_motor(const Table& table, const DriveKeys& keys, AxisParameters& axis) {
  const bool as_joint = keys.left_out("motor_min") && keys.left_out("motor_max");
  axis.motor_min = as_joint ? axis.position_min : table.limit("motor_min");
  axis.motor_max = as_joint ? axis.position_max : above(table, "motor_max", axis.motor_min, "motor_min");
  axis.motor_synchro = keys.left_out("motor_synchro") ? std::clamp(0.0, axis.motor_min, axis.motor_max)
                                                      : table.number("motor_synchro", {axis.motor_min, axis.motor_max});
  axis.synchro_coarse = table.number_or("synchro_coarse", 0);
  axis.synchro_fine = table.number_or("synchro_fine", 0);
  if (axis.synchro_coarse * axis.synchro_fine > 0 || (axis.synchro_coarse == 0) != (axis.synchro_fine == 0)) {
    table.fail("synchro_fine", number_text(axis.synchro_fine) + " does not have the opposite sign of synchro_coarse",
               axis.synchro_coarse == 0  ? "0"
               : axis.synchro_coarse > 0 ? "a number below 0"
                                         : "a number above 0");
  }
}

/// One number, or the least and the greatest.
void read_inertia(const Table& table, AxisParameters& axis) {
  if (!table.has("inertia")) return;
  const std::vector<double> range = table.numbers("inertia", 2, kInertia);
  if (!(range[0] <= range[1]))
    table.fail("inertia", number_text(range[0]) + " is above " + number_text(range[1]), "the least, the greatest");
  axis.inertia_min = range[0];
  axis.inertia_max = range[1];
}

void read_regulator(const Table& table, const DriveKeys& keys, AxisParameters& axis) {
  constexpr std::array kNumbers{"regulator_a", "regulator_b0", "regulator_b1", "regulator_eps",
                                "regulator_current_gain"};
  const bool given = std::any_of(kNumbers.begin(), kNumbers.end(), [&](const char* key) { return table.has(key); });
  if (!given && keys.bandwidth() > 0) {  // the type designs it, when it knows the gears
    if (!(axis.inertia_max > 0))
      table.fail("inertia", "missing, and the regulator is to be designed", "[the least, the greatest] at the joint");
    axis.regulator_bandwidth = positive_or(table, "regulator_bandwidth", keys.bandwidth());
    return;
  }
  axis.regulator_a = keys.number("regulator_a", 0);
  axis.regulator_b0 = keys.number("regulator_b0", 0);
  axis.regulator_b1 = keys.number("regulator_b1", 0);
  axis.regulator_eps = keys.number("regulator_eps", 0);
  axis.regulator_output_max = positive_or(table, "regulator_output_max", axis.regulator_output_max);
  axis.regulator_current_gain = keys.positive("regulator_current_gain", 1);
}

}  // namespace

double positive(const Table& table, std::string_view key) {
  const double value = table.number(key);
  if (!(value > 0)) table.fail(key, number_text(value) + " is not positive", "a number above 0");
  return value;
}

double positive_or(const Table& table, std::string_view key, double fallback) {
  return table.has(key) ? positive(table, key) : fallback;
}

DriveParameters read_drives(const Table& file) {
  DriveParameters drives;
  const auto table = file.optional_table("drives");
  if (!table) return drives;
  if (table->choice("regulates", {"framework", "itself"}) == "itself") {
    drives.interface = DriveParameters::Interface::position;
    if (table->has("interface") && table->choice("interface", {"position", "velocity"}) == "velocity")
      drives.interface = DriveParameters::Interface::velocity;
    drives.bandwidth = table->number_or("bandwidth", kUsualBandwidth, kBandwidth);
    if (drives.interface == DriveParameters::Interface::velocity)
      drives.position_gain =
          positive_or(*table, "position_gain", kUsualCorrection * 2 * std::numbers::pi * drives.bandwidth);
  } else if (table->has("bandwidth")) {
    if (!file.has("chain"))
      table->fail("bandwidth", "regulators are designed for arms with a table [chain] only",
                  "numbers of the regulators in [[axes]]");
    drives.bandwidth = table->number("bandwidth", kBandwidth);
  }
  table->finish();
  return drives;
}

AxisParameters read_axis(const Table& table, const DriveParameters& drives) {
  const DriveKeys keys(table, drives);
  AxisParameters axis;
  axis.name = table.text("name");
  if (axis.name.empty() || axis.name.size() > kNameLength) {
    table.fail("name", in_quotes(axis.name) + " is not a valid name",
               "1 to " + std::to_string(kNameLength) + " characters");
  }
  axis.position_min = table.limit("position_min");
  axis.position_max = above(table, "position_max", axis.position_min, "position_min");
  axis.velocity_max = positive(table, "velocity_max");
  axis.acceleration_max = positive(table, "acceleration_max");
  axis.jerk_max = positive(table, "jerk_max");
  axis.torque_max = positive_or(table, "torque_max", axis.torque_max);
  read_inertia(table, axis);
  read_motor(table, keys, axis);
  axis.encoder_increments = positive_or(
      table, "encoder_increments", keys.left_out("encoder_increments") ? kUsualIncrements : axis.encoder_increments);
  axis.current_max = keys.positive("current_max", axis.torque_max);
  axis.current_max_time = positive_or(table, "current_max_time", axis.current_max_time);
  axis.following_error_max = keys.positive("following_error_max", kUsualError);
  axis.stuck_max = positive_or(table, "stuck_max", kUsualStuck * axis.following_error_max);
  // the push of a drive that regulates on its own says nothing without numbers of its motor
  axis.stuck_current = not_negative_or(table, "stuck_current", keys.left_out("rotor_inertia") ? axis.stuck_current : 0);
  read_regulator(table, keys, axis);
  axis.torque_constant = keys.positive("torque_constant", 1);
  axis.rotor_inertia = keys.positive("rotor_inertia", 1);
  axis.viscous_friction = keys.positive("viscous_friction", 1);
  table.finish();
  return axis;
}

}  // namespace mrroc::config
