#pragma once

#include "config/drives/io_table.hpp"

namespace mrroc::config {

/// Throws ConfigurationError at `eds` of `table` when the EDS file of the node lacks an object that its PDOs carry.
void check_io_eds(const Table& table, const IoEntry& node);

/// Refuses the objects of an I/O node that the EDP writes itself.
void check_io_object(const Table& table, const std::string& key, canopen::Object object);

}  // namespace mrroc::config
