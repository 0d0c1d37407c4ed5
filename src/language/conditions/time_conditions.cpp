// Conditions on the elapsed time and the age of a reading: ElapsedTime, ReadingOlderThan.
#include "core/require.hpp"
#include "core/short_number.hpp"
#include "mrroc/conditions/elapsed_time.hpp"
#include "mrroc/conditions/reading_older_than.hpp"
#include "mrroc/task.hpp"

namespace mrroc {

ElapsedTime::ElapsedTime(const Task& task, double seconds)
    : Condition("elapsed " + short_number(seconds) + " s"), task_(&task), seconds_(seconds) {
  require_not_negative("ElapsedTime", "time", seconds);
}

void ElapsedTime::start() { origin_ = task_->tick(); }

bool ElapsedTime::holds() {
  // half a tick of tolerance: products with the period are not exact
  const double period = task_->servo_period();
  return static_cast<double>(task_->tick() - origin_) * period >= seconds_ - 0.5 * period;
}

ReadingOlderThan::ReadingOlderThan(const Sensor& sensor, double seconds)
    : Condition(sensor.name() + " reading older than " + short_number(seconds) + " s"),
      sensor_(&sensor),
      seconds_(seconds) {
  require_not_negative("ReadingOlderThan", "time", seconds);
}

}  // namespace mrroc
