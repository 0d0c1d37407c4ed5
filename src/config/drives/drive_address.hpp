#pragma once

#include "config/drives/drive_table.hpp"
#include "config/table.hpp"

namespace mrroc::config {

/// Reads where a drive is on the bus: `node`, and of an axis of a drive with several `channel`, `first_pdo` and
/// `pdo_node`: its PDOs have no predefined identifiers, and get those of a number that no node has. Throws
/// ConfigurationError.
void read_address(const Table& table, DriveEntry& drive);

/// Throws ConfigurationError at the key: a number in use by the master, the SYNC or a drive in `drives`, all of which
/// come before; an axis that the EDS file does not have.
void check_address(const Table& table, const DriveEntry& drive, const DriveTable& drives);

}  // namespace mrroc::config
