#pragma once

#include <memory>

#include "config/deployment.hpp"
#include "sensors/camera/detection/detection.hpp"

namespace mrroc::vsp {

/// The detector of the key `detect` with the keys of its own. Throws SystemError(configuration) naming the key, the
/// value and the expected value.
std::unique_ptr<Detector> make_detector(const config::SensorEntry& entry);

}  // namespace mrroc::vsp
