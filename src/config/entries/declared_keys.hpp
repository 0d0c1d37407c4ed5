#pragma once

#include <span>
#include <string_view>

#include "config/key_values.hpp"
#include "config/table.hpp"

namespace mrroc::config {

/// Reads the keys that the file `type` of a sensor type or driver declares, from `table` of a deployment. One table for
/// each key:
///
///     [parameters.range]
///     kind = "number"      # number | numbers | integer | boolean | text
///     default = 4.0        # left out: the key is required
///     min = 0.1            # bounds of a number, of an integer, or of each of the numbers, both included
///     max = 10.0
///     unit = "m"
///     text = "farthest distance that the sensor measures"
///
/// `size` fixes how many `numbers` there are; `choices` lists the texts that are allowed. Keys of `reserved` may not be
/// declared. A default is read even when it is not needed, so that a wrong one is reported early. Throws
/// ConfigurationError, which names the deployment file for a wrong value and the type's file for a wrong declaration.
/// Marks the declared keys of `table` as used.
void read_declared_keys(const Table& type, const Table& table, std::span<const std::string_view> reserved,
                        KeyValues& values);

}  // namespace mrroc::config
