#pragma once

#include <string>

#include "mrroc/message.hpp"
#include "mrroc/sensor_link.hpp"

namespace mrroc {

class Task;

/// One virtual sensor v_p in a task program. *Interactive*: `Move` requests a reading before it commands the robots and
/// collects it after their replies, so that measuring overlaps motion. *Polled*: the same, but `Move` does not wait for
/// the reading: it collects it at the first step at which it has arrived, and then requests the next one.
/// *Non-interactive*: `Move` reads the newest published reading from a local buffer and never waits. The deployment
/// selects one of the three. A sensor of a given type is a class derived from this one that names the channels. Task's
/// thread only.
class Sensor {
 public:
  /// A member of the task, or made in its constructor. Throws NonFatalError(invalid_argument) when the deployment has
  /// no sensor `name` of `type`, or when the task is already running and has not opened the link before.
  Sensor(Task& task, const std::string& name, const std::string& type);
  virtual ~Sensor() = default;
  Sensor(const Sensor&) = delete;
  Sensor& operator=(const Sensor&) = delete;

  const std::string& name() const noexcept { return name_; }
  Task& task() const noexcept { return *task_; }
  bool interactive() const noexcept { return interactive_; }
  /// v^i, as of the last step at which it was due.
  const SensorReading& reading() const noexcept { return reading_; }
  /// Channel `channel` of the reading; NaN when the reading does not contain it.
  double value(std::size_t channel) const noexcept;
  /// Whether the last collection brought a new reading. It may be false for a polled or non-interactive sensor: not
  /// ready is then not an error, and `reading()` does not change (before the first reading of a polled sensor it is
  /// empty, all values NaN).
  bool fresh() const noexcept { return fresh_; }
  /// Time since the hardware was read for `reading()`, s; infinite before the first one.
  double age() const noexcept;

  /// A new reading every `steps` steps of a Move or Wait (1: every step). Throws NonFatalError when 0.
  void set_period(std::uint32_t steps);
  std::uint32_t period() const noexcept { return period_; }

  /// Takes the present reading as zero, for every client of the sensor, and waits for the new one, which `reading()`
  /// then returns. Throws NonFatalError (invalid_argument) when the sensor is non-interactive, the reading's error if
  /// any, SystemError when the VSP died or is silent.
  void bias();

  /// c_l in the paper's equation (14), v_p = f(c_0, c_l, e_l, r): the sensor works with `configuration` from its next
  /// reading on, for every client. An exchange of its own, between two instructions; the sensor's type says which
  /// configurations it takes: `wrist.configure(Carrying{1.2, {0, 0, 0.1}})`. Afterwards `reading()` is empty (all
  /// values NaN) until the first reading that was made with it, also where an older one arrives in between (polled and
  /// non-interactive sensors). Throws NonFatalError: busy while an instruction of another fiber reads it,
  /// invalid_argument with the sensor's reason when it refuses (nothing has changed then); SystemError when the VSP
  /// died or is silent.
  template <MessageType Configuration>
  void configure(const Configuration& configuration) {
    configure_with(pack(configuration));
  }
  /// The number of the configuration that this task was the last to set; 0: it has set none. Readings made with a later
  /// one, of another client, have a greater number in `reading().configuration`.
  std::uint32_t configuration() const noexcept { return configuration_; }

  // ---- the exchange, used by Move and Wait
  // -----------------------------------------------------------------------------
  /// Reserves an interactive sensor for one instruction, until `release`. Throws NonFatalError(busy) when an
  /// instruction of another fiber of the task has it. A non-interactive sensor serves any number of instructions.
  void acquire();
  void release() noexcept { in_use_ = false; }
  /// Whether v^i is updated at step i of an instruction: i is a multiple of the period.
  bool due(std::uint64_t step) const noexcept { return step % period_ == 0; }
  /// Requests a reading of the hardware at `measure_at` (polled: at once), unless one is under way. Does nothing for a
  /// non-interactive sensor.
  void initiate_reading(Tick measure_at);
  /// Stores the reading: awaits the reply to the request (interactive), checks for it (polled), or reads the buffer.
  void collect_reading();

 private:
  void configure_with(const Message& configuration);
  void take(const SensorReading& reading) noexcept;

  Task* task_;
  std::string name_;
  bool interactive_ = true;
  SensorLink* link_;
  SensorReading reading_;
  SensorReading arrived_;
  std::uint32_t configuration_ = 0;
  std::uint32_t period_ = 1;
  bool asked_ = false;  ///< a polled sensor's reading is under way
  bool fresh_ = false;
  bool in_use_ = false;
};

}  // namespace mrroc
