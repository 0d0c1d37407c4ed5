#pragma once

#include <string>

#include "config/table.hpp"

namespace mrroc::config {

/// Refuses, at `key` of `table`, a name that is not a letter followed by letters, digits and `_`, at most kNameLength
/// characters in all: it becomes part of DDS topics, of file names and of fixed-size messages.
void check_name(const Table& table, std::string_view key, const std::string& name);

/// The same for a robot or sensor, which also may not have the name of a process of the framework (mp, sim, operator)
/// and has at most 27 characters: the EDP of a robot is the process <robot>_edp.
void check_device_name(const Table& table, const std::string& name);

}  // namespace mrroc::config
