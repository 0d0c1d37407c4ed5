#pragma once

#include "mrroc/raw_reading.hpp"

namespace mrroc::vsp {

using mrroc::kMaxRawValues;
using mrroc::RawReading;

}  // namespace mrroc::vsp
