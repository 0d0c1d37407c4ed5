#pragma once

#include "canopen/drive_state.hpp"
#include "config/drives/node_objects.hpp"

namespace mrroc::config {

/// The framework's EDS file of a drive.
inline constexpr const char* kGeneralDriveEds = "cia402.eds";

/// Reads a drive's EDS file. Throws ConfigurationError, also when it lacks an object that the cycle of `mode` needs.
canopen::EdsFile read_drive_eds(const Table& table, canopen::DriveMode mode);

/// Refuses the objects of a drive that the EDP writes itself.
CheckObject check_drive_object(bool absolute_encoders);

}  // namespace mrroc::config
