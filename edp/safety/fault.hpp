#pragma once

#include <variant>

#include "mrroc/errors.hpp"
#include "mrroc/fixed_text.hpp"
#include "mrroc/types.hpp"

namespace mrroc::edp {

/// A value beyond its limit, in the unit of the error code: rad, m, rad/s or A.
struct Excess {
  double value = 0, limit = 0;
};

/// A reading that is not a finite number.
struct NotFinite {};

/// Position of a shaft, rad.
struct ShaftPosition {
  double position = 0;
};

/// Text of a driver about its drives or its bus.
using DriverText = FixedText<127>;

/// Details of a fault beyond its error code. Drivers compose a DriverText when the fault occurs.
using FaultDetail = std::variant<std::monostate, Excess, NotFinite, ShaftPosition, DriverText>;

/// Text of the detail, such as "1.204, limit 1.2", with as many digits as make the two differ; empty for monostate. Any
/// thread; allocates nothing, never throws.
DriverText describe(const FaultDetail& detail) noexcept;

/// Formats like printf and truncates. Any thread; allocates nothing, never throws.
[[gnu::format(printf, 1, 2)]] DriverText driver_text(const char* format, ...) noexcept;

/// The fault that stopped the robot, latched until the drives are enabled again.
struct Fault {
  ErrorCode code = ErrorCode::none;
  int axis = -1;  ///< from 0; -1: the whole robot
  FaultDetail detail{};
  Tick tick = 0;
};

}  // namespace mrroc::edp
