#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "config/deployment.hpp"

namespace mrroc::cli {

/// A number of a calibration that the user may set: the option --NAME and the field of the behaviour.
struct CalibrationSetting {
  std::string name;  ///< of the field; the option has '-' for '_'
  bool whole;        ///< an integer
  double value;      ///< the default
  double min, max;
  std::string text;       ///< for help
  bool required = false;  ///< `value` is no default
};

/// A kind of calibration: the program calibrate_NAME, whose behaviour has the fields `sensor`, `into` and the settings.
struct CalibrationKind {
  std::string name;
  std::string behaviour;
  std::string sensor_type;                         ///< of the sensor that measures
  std::string text;                                ///< for help
  std::map<std::string, std::string> sensor_keys;  ///< keys that the sensor has during the calibration
  std::vector<CalibrationSetting> settings;
  bool on_robot = true;     ///< whether the robot carries the sensor; else it does not move
  bool fixed_base = false;  ///< whether the robot may not be carried by another one
};

/// Every kind that exists.
std::vector<CalibrationKind> calibration_kinds();

/// The user's order; a name that is left out is that of the only device.
struct CalibrationOrder {
  std::string robot, sensor;
  std::filesystem::path into;
};

/// The deployment and the state machine of one run of a calibration. Main thread.
class CalibrationRun {
 public:
  /// `kind`: with the user's values. Throws ConfigurationError that names the option: there is no such robot or sensor,
  /// several come into question, or `into` is in no folder.
  CalibrationRun(CalibrationKind kind, const config::Deployment& deployment, CalibrationOrder order);
  /// Removes the state machine's file.
  ~CalibrationRun();
  CalibrationRun(const CalibrationRun&) = delete;
  CalibrationRun& operator=(const CalibrationRun&) = delete;

  const std::string& robot() const noexcept { return order_.robot; }
  const std::string& sensor() const noexcept { return order_.sensor; }
  /// The deployment `text` with the program of the calibration as its task.
  std::string deployment_text(const std::string& text) const;

 private:
  std::string states() const;

  CalibrationKind kind_;
  CalibrationOrder order_;
  std::filesystem::path folder_;
};

}  // namespace mrroc::cli
