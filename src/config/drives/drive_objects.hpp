#pragma once

#include <vector>

#include "canopen/drive_state.hpp"
#include "canopen/eds_file.hpp"
#include "config/drives/drive_table.hpp"
#include "config/table.hpp"

namespace mrroc::config {

/// Where the EDS file of `eds = "NAME"` is: beside the table, or the framework's in share/mrroc/canopen/standard.
/// Throws ConfigurationError when it is in neither.
std::filesystem::path eds_file(const Table& table);

/// What it says. Throws ConfigurationError, also when it lacks an object that the cycle of `mode` needs.
canopen::EdsFile read_eds(const Table& table, canopen::DriveMode mode);

/// Appends the table `objects` of `owner`: objects by name or address, and the values to write. Of `drives` the EDS
/// file and the kind of encoders are used. Throws ConfigurationError: no object of the EDS file, one that may not be
/// written or that the EDP writes on its own, one given twice, a value that its type does not hold.
void read_settings(const Table& owner, const DriveTable& drives, std::vector<DriveSetting>& settings);

}  // namespace mrroc::config
