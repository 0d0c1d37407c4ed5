#pragma once

#include <string>

#include "mrroc/sensor_link.hpp"

namespace mrroc {

class Task;

/// One virtual sensor v_p as a task program sees it. *Interactive*: `Move` requests a reading before the robots are
/// commanded and collects it after their replies, so that measuring overlaps motion; *polled*: likewise, but a reading
/// that has not come by then is not waited for: it is collected at the first step at which it is there, and requested
/// again after that; *non-interactive*: the newest published reading is read from a local buffer, never waiting. Which
/// of the three is the deployment's choice. A sensor of a given type is a class derived from this one that names the
/// channels. Task's thread only.
class Sensor {
 public:
  /// A member of the task, or made in its constructor. Throws NonFatalError(invalid_argument) when the deployment has
  /// no sensor `name` of `type`, or when the task runs already and no object of it has opened the link before.
  Sensor(Task& task, const std::string& name, const std::string& type);
  virtual ~Sensor() = default;
  Sensor(const Sensor&) = delete;
  Sensor& operator=(const Sensor&) = delete;

  const std::string& name() const noexcept { return name_; }
  Task& task() const noexcept { return *task_; }
  bool interactive() const noexcept { return interactive_; }
  /// v^i, as of the last step at which it was due.
  const SensorReading& reading() const noexcept { return reading_; }
  /// Channel `channel` of the reading; NaN when it does not have it.
  double value(std::size_t channel) const noexcept;
  /// Whether the last collection brought a reading that was not there before. Of a polled or non-interactive sensor it
  /// may be false: not ready is a value there, no error, and `reading()` stays (of a polled sensor: empty, all values
  /// NaN, before the first one).
  bool fresh() const noexcept { return fresh_; }
  /// Time since the hardware was read for `reading()`, s; infinite before the first one.
  double age() const noexcept;

  /// A new reading every `steps` steps of a Move or Wait (1: every step). Throws NonFatalError when 0.
  void set_period(std::uint32_t steps);
  std::uint32_t period() const noexcept { return period_; }

  /// Takes the present reading as zero, for every client of the sensor, and waits for the new one, which `reading()`
  /// then is. Throws NonFatalError (invalid_argument) when the sensor is non-interactive, the reading's error when it
  /// has one, SystemError when the VSP died or is silent.
  void bias();

  // ---- the exchange, used by Move and Wait
  // -----------------------------------------------------------------------------
  /// Takes an interactive sensor for one instruction, until `release`. Throws NonFatalError(busy) when another one has
  /// it: one of another strand of the task. A non-interactive sensor serves any number.
  void acquire();
  void release() noexcept { in_use_ = false; }
  /// Whether v^i is renewed at step i of an instruction: i is a multiple of the period.
  bool due(std::uint64_t step) const noexcept { return step % period_ == 0; }
  /// Requests a reading of the hardware at `measure_at`, of a polled sensor at once, unless one is under way; a
  /// non-interactive sensor does nothing.
  void initiate_reading(Tick measure_at);
  /// Stores the reading: awaits the reply to the request, looks whether it has come, or reads the buffer.
  void collect_reading();

 private:
  Task* task_;
  std::string name_;
  bool interactive_ = true;
  SensorLink* link_;
  SensorReading reading_;
  std::uint32_t period_ = 1;
  bool asked_ = false;  ///< a polled sensor's reading is under way
  bool fresh_ = false;
  bool in_use_ = false;
};

}  // namespace mrroc
