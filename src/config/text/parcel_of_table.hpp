#pragma once

#include "config/table.hpp"
#include "mrroc/message.hpp"

namespace mrroc::config {

/// Makes the message of type `schema` out of the values that a table has for its fields, all of them: a number, an
/// integer, a truth, a text, an array of numbers; a pose is [x, y, z, roll, pitch, yaw] in m and rad about fixed axes
/// x, y, z. Throws ConfigurationError.
Message parcel_of(const Table& table, const MessageSchema& schema);

/// "x = 0.6, y = 0.1": the same values for people.
std::string arguments_text(const Table& table, const MessageSchema& schema);

}  // namespace mrroc::config
