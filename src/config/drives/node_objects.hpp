#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "canopen/eds_file.hpp"
#include "canopen/objects.hpp"
#include "config/table.hpp"

namespace mrroc::config {

/// A value that is written into a node of a CAN bus before the node is used.
struct NodeSetting {
  canopen::Object object;
  std::string name;  ///< as in the file
  std::int64_t value = 0;
  std::uint8_t size = 0;  ///< bytes
};

/// Where the EDS file of `eds = "NAME"` is: beside the table, or the framework's in share/mrroc/canopen/standard.
/// Throws ConfigurationError when neither has it; the message names `general`, the framework's file for such nodes.
std::filesystem::path eds_file(const Table& table, const std::string& general);

/// Reads it. Throws ConfigurationError.
canopen::EdsFile load_eds(const Table& table, const std::string& general);

/// Throws ConfigurationError at `key` when the table may not set `object`.
using CheckObject = std::function<void(const Table& table, const std::string& key, canopen::Object object)>;

/// Appends the table `objects` of `owner`: objects of `eds` by name or address, and the values to write. Throws
/// ConfigurationError: an object that is not in the EDS file, is read-only, is refused by `check` or is given twice; a
/// value out of the range of its type.
void read_settings(const Table& owner, const canopen::EdsFile& eds, const CheckObject& check,
                   std::vector<NodeSetting>& settings);

}  // namespace mrroc::config
