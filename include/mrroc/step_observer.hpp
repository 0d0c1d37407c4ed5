#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "mrroc/condition.hpp"
#include "mrroc/robot.hpp"
#include "mrroc/sensor.hpp"

namespace mrroc {

/// What ends an instruction at a step.
enum class StepEnding : std::uint8_t {
  none,             ///< nothing: it goes on, and every robot is commanded
  condition,        ///< the condition waited for, or given to the generator with `until`, holds: f_I, f_T
  generator,        ///< the generator's own terminal condition holds: f_T
  end_motion,       ///< the operator or the superior process asks for the next instruction
  stopped,          ///< `Stopped` is thrown
  non_fatal_error,  ///< f_E: an Error of this class is thrown
  hardware_error,
  system_error
};

/// One step of a Move or Wait, seen after f_T / f_I and the next command are known, or when an error ends it. Valid
/// during the call only.
struct StepRecord {
  bool is_move = false;
  std::uint64_t instruction = 0;       ///< counts the task's instructions, from 1
  const std::string* name = nullptr;   ///< of the generator, or of the condition waited for
  const std::string* until = nullptr;  ///< of a Move: name of the condition that ends it; null: it has none
  /// i - i0. When `Stopped` or a SystemError breaks an exchange off it is that of the command that got no answer.
  std::uint64_t step = 0;
  /// Macrosteps in which the robots held between the command before and this step: a pause, a command that was late.
  std::uint64_t held = 0;
  Tick tick = 0;      ///< of the newest state or reading
  bool last = false;  ///< the instruction ends here: no command is sent
  StepEnding ending = StepEnding::none;
  Tick skew = 0;  ///< of the robots, worst so far in this instruction: Outcome::skew
  std::span<Robot* const> robots;
  std::span<Sensor* const> sensors;
  /// Leaves; each has its value. None at an end at which they are not evaluated: end-motion, `Stopped`, errors.
  std::span<const Condition* const> conditions;
};

/// Is told every step of every Move and Wait of a task: traces, progress displays. Called when the commands have been
/// sent and no reply is awaited yet, on the task's thread: it must neither allocate, block nor throw.
class StepObserver {
 public:
  virtual ~StepObserver() = default;
  virtual void on_step(const StepRecord& record) noexcept = 0;
};

}  // namespace mrroc
