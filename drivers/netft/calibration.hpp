#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace mrroc::netft {

/// Newtons in one unit of force: N, kN, lbf, klbf, kgf, gf. Nothing: another unit. Hyphens and blanks do not count.
std::optional<double> newtons(std::string_view unit);
/// Newton metres in one unit of torque: N-m, N-mm, kN-m, lbf-in, lbf-ft, kgf-cm, with or without the hyphen. Nothing:
/// another unit.
std::optional<double> newton_metres(std::string_view unit);

/// Factors from the counts of a record to SI units.
struct Calibration {
  double newtons_per_count = 0;
  double newton_metres_per_count = 0;
};

/// The settings of a Net F/T that its client needs.
struct SensorConfiguration {
  Calibration calibration;
  std::string product;       ///< name of the product; may be empty
  double rate = 0;           ///< records per second of a stream, Hz; 0: not on the page
  bool rdt_enabled = true;   ///< false: the sensor does not answer RDT requests
  std::uint32_t status = 0;  ///< of the system, as in a record
};

/// Path of the configuration page: manual 9620-05-NET FT, section "Net F/T XML Pages".
inline constexpr const char* kConfigurationPath = "/netftapi2.xml";

/// Reads the configuration page: `cfgcpf` and `cfgcpt`, counts per unit; `scfgfu` and `scfgtu`, the names of the units,
/// or their codes `cfgfu` and `cfgtu`; `comrdtrate`, `comrdte`, `runstat` and `prodname` where they exist. `address` is
/// the page's in messages. Throws ConfigurationError with the address, the line and the element: text that is not XML,
/// a missing or repeated element, a value that is not a positive number or an unknown unit.
SensorConfiguration read_configuration(const std::string& xml, const std::string& address);

}  // namespace mrroc::netft
