#pragma once

#include <vector>

#include "mrroc/robot.hpp"
#include "mrroc/sensor.hpp"
#include "mrroc/task.hpp"

namespace mrroc {

/// The task to which the robots and sensors of one instruction belong. Throws NonFatalError(invalid_argument) when both
/// lists are empty, an element is a null pointer or stands twice, or they belong to different tasks. The task's thread.
Task& task_of(const std::vector<Robot*>& robots, const std::vector<Sensor*>& sensors);

}  // namespace mrroc
