#pragma once

#include <vector>

#include "canopen/drive_state.hpp"
#include "canopen/eds_file.hpp"
#include "config/drives/drive_table.hpp"
#include "config/table.hpp"

namespace mrroc::config {

/// Where the EDS file of `eds = "NAME"` is: beside the table, or the framework's in share/mrroc/canopen/standard.
/// Throws ConfigurationError when neither has it.
std::filesystem::path eds_file(const Table& table);

/// Reads it. Throws ConfigurationError, also when it lacks an object that the cycle of `mode` needs.
canopen::EdsFile read_eds(const Table& table, canopen::DriveMode mode);

/// Appends the table `objects` of `owner`: objects by name or address, and the values to write. Uses the EDS file and
/// the kind of encoders of `drives`. Throws ConfigurationError: an object that is not in the EDS file, is read-only, is
/// written by the EDP itself or is given twice; a value out of the range of its type.
void read_settings(const Table& owner, const DriveTable& drives, std::vector<DriveSetting>& settings);

}  // namespace mrroc::config
