#include "cli/robot/import/axis_drives.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <limits>
#include <random>

#include "cli/robot/import/toml_text.hpp"
#include "config/table.hpp"
#include "config/text/message_text.hpp"

namespace mrroc::cli {

namespace {

constexpr int kInertiaPostures = 1000;
constexpr std::uint64_t kInertiaSeed = 6;
constexpr double kRotor = 0.1;        // of the greatest inertia
constexpr double kRunOut = 1;         // s, in which friction stops a rotor
constexpr double kTorqueError = 0.2;  // rad or m: before the regulators bear the weight, the arm sags

/// With three digits: it is a guess, or depends on guesses.
double rounded(double value) { return std::stod(fmt::format("{:.3g}", value)); }

}  // namespace

std::vector<AxisDrive> drives_of(const std::vector<AxisLimits>& axes, ArmWorld& world) {
  std::vector<AxisDrive> drives(axes.size());
  for (AxisDrive& drive : drives) drive.inertia_min = std::numeric_limits<double>::infinity();
  std::mt19937_64 random(kInertiaSeed);
  for (int i = 0; i < kInertiaPostures; ++i) {
    const JointVector inertia = world.inertia(random_posture(axes, random));
    for (std::size_t j = 0; j < axes.size(); ++j) {
      const double own = std::max(inertia[static_cast<Eigen::Index>(j)], 1e-6);
      drives[j].inertia_min = std::min(drives[j].inertia_min, own);
      drives[j].inertia_max = std::max(drives[j].inertia_max, own);
    }
  }
  for (AxisDrive& drive : drives) drive.rotor = kRotor * drive.inertia_max;
  return drives;
}

std::string drives_text(DriveKind kind) {
  std::string text = "\n[drives]\n";
  if (kind == DriveKind::itself) {
    text += "regulates = \"itself\"  # guessed: the arm's own controller follows positions\n";
    text += "interface = \"position\"  # guessed\nbandwidth = 20.0  # Hz, guessed\n";
  } else {
    text += "regulates = \"framework\"  # the arm's drives follow torques\n";
    text += "bandwidth = 5.0  # Hz, guessed: crossover of the regulators that the framework designs\n";
  }
  return text;
}

std::string drive_text(DriveKind kind, const AxisLimits& axis, const AxisDrive& drive) {
  const auto line = [](const char* key, double value, const char* source) {
    std::string text = key;
    text += " = ";
    text += toml_number(value);
    text += "  # ";
    text += source;
    text += "\n";
    return text;
  };
  Eigen::Vector2d inertia(rounded(drive.inertia_min), rounded(drive.inertia_max));
  std::string text = "inertia = ";
  text += toml_array(inertia);
  text += "  # from the URDF: least and greatest of 1000 postures\n";
  if (kind == DriveKind::itself) return text;
  text += line("motor_min", axis.position_min.value, "the joint itself: no gear between torque and joint");
  text += line("motor_max", axis.position_max.value, "the same");
  text += line("motor_synchro", std::clamp(0.0, axis.position_min.value, axis.position_max.value), "the same");
  text += line("encoder_increments", 1 << 20, "guessed");
  text += line("current_max", axis.torque->value, "as torque_max: 1 A stands for 1 N m or 1 N");
  text += line("torque_constant", 1, "the same");
  text += line("following_error_max", kTorqueError, "guessed");
  text += line("rotor_inertia", rounded(drive.rotor), "guessed: a tenth of the greatest inertia");
  return text + line("viscous_friction", rounded(drive.rotor / kRunOut), "guessed: it stops the rotor in 1 s");
}

void note_drives(DriveKind kind, const std::vector<AxisLimits>& axes, const std::filesystem::path& urdf,
                 Findings& findings) {
  if (kind == DriveKind::itself) {
    findings.guess("inertia of rotor and gear: a tenth of the axis's inertia at home", "armature of all axes", 0);
    findings.guess("regulates = \"itself\", interface = \"position\", bandwidth = 20 Hz", "[drives]", 0);
    return;
  }
  for (const AxisLimits& axis : axes)
    if (!axis.torque)
      throw config::ConfigurationError(urdf, 0, "--drives torque",
                                       "axis " + config::in_quotes(axis.name) + " has no effort in the URDF",
                                       "torque_max of it in --limits FILE");
  findings.guess("bandwidth = 5 Hz of the regulators, following error 0.2", "[drives]", 0);
  findings.guess("inertia, a tenth of the axis's greatest, and friction of rotor and gear", "motors of all axes", 0);
}

}  // namespace mrroc::cli
