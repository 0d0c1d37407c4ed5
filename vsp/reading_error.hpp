#pragma once

#include "mrroc/sensor_link.hpp"

namespace mrroc::vsp {

/// Marks `v` as a reading in error: class, code, a printf-formatted detail, and NaN in every channel, so that no value
/// can be mistaken for a measured one. Any thread; allocates nothing, never throws.
[[gnu::format(printf, 4, 5)]] void report(SensorReading& v, ErrorClass error_class, ErrorCode code, const char* format,
                                          ...) noexcept;

}  // namespace mrroc::vsp
