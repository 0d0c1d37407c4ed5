#pragma once

#include <vector>

#include "mrroc/robot.hpp"
#include "mrroc/sensor.hpp"
#include "mrroc/task.hpp"

namespace mrroc {

/// The task to which the robots and sensors of one instruction belong. Throws NonFatalError(invalid_argument) when both
/// lists are empty, an element is a null pointer or is listed twice, or they belong to different tasks. Task's thread.
Task& task_of(const std::vector<Robot*>& robots, const std::vector<Sensor*>& sensors);

/// Reserves the robots and interactive sensors for one instruction during its lifetime. The lists must outlive it.
class ExclusiveUse {
 public:
  /// Throws NonFatalError(busy) when an instruction of another fiber has one of them.
  ExclusiveUse(const std::vector<Robot*>& robots, const std::vector<Sensor*>& sensors);
  ~ExclusiveUse() { release(); }
  ExclusiveUse(const ExclusiveUse&) = delete;
  ExclusiveUse& operator=(const ExclusiveUse&) = delete;

 private:
  void release() noexcept;

  const std::vector<Robot*>& robots_;
  const std::vector<Sensor*>& sensors_;
  std::size_t acquired_ = 0;  // robots, then sensors
};

}  // namespace mrroc
