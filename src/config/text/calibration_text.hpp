#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// Deployment texts whose keys are replaced: by calibration files, and for a run of `mrroc calibrate`. Configuration
/// time only.
namespace mrroc::config {

/// The calibration files that `text` of the deployment `file` names: `[deployment] calibration = ["wrist.toml"]`. A
/// path starts at the deployment's folder. Throws ConfigurationError: it is not an array of texts, or there is no such
/// file.
std::vector<std::filesystem::path> calibration_files(const std::filesystem::path& file, const std::string& text);

/// `text` of the deployment `file` with the keys of its calibration files in the place of its own, without the names of
/// these files: who reads the result does not read them. A calibration
/// file has tables [robots.NAME] and [sensors.NAME] of the deployment; a key there replaces the deployment's as a
/// whole, the last file counts. Without such files, and where `text` is not valid TOML: `text` itself.
///
/// Throws ConfigurationError as calibration_files(), and when a file is invalid or names a device that the deployment
/// does not have.
std::string with_calibrations(const std::filesystem::path& file, const std::string& text);

/// Where `key` ("robots.arm.joint_zeros[2]") of a deployment with `with_calibrations` comes from.
struct CalibrationLine {
  std::filesystem::path file;
  int line = 0;
};
/// Of the last of its calibration files that has the key; nothing when none has it. Throws as `with_calibrations`.
std::optional<CalibrationLine> calibration_line(const std::filesystem::path& file, const std::string& text,
                                                std::string_view key);

/// A calibration as the task of a deployment.
struct CalibrationTask {
  std::string robot, program;                      ///< the ECP of this robot runs this program
  std::filesystem::path states;                    ///< the state machine of the stock MP, absolute
  std::string sensor;                              ///< that measures
  std::map<std::string, std::string> sensor_keys;  ///< texts that replace those of the sensor
};

/// `text` of a valid deployment with `task` in the place of its own: every other robot has the stock ECP; events and
/// prepared answers are left out.
std::string for_calibration(const std::string& text, const CalibrationTask& task);

}  // namespace mrroc::config
