#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "mrroc/condition.hpp"
#include "mrroc/robot.hpp"
#include "mrroc/sensor.hpp"

namespace mrroc {

/// One step of a Move or Wait, seen after f_T / f_I and the next command are known. Valid during the call only.
struct StepRecord {
  bool is_move = false;
  std::uint64_t instruction = 0;      ///< counts the task's instructions, from 1
  const std::string* name = nullptr;  ///< of the generator, or of the condition waited for
  std::uint64_t step = 0;             ///< i - i0
  Tick tick = 0;                      ///< of the newest state or reading
  bool last = false;                  ///< the instruction ends here: no command is sent
  Tick skew = 0;                      ///< of the robots, worst so far in this instruction: Outcome::skew
  std::span<Robot* const> robots;
  std::span<Sensor* const> sensors;
  std::span<const Condition* const> conditions;  ///< leaves; each has its value. None at the operator's end-motion
};

/// Is told every step of every Move and Wait of a task: traces, progress displays. Called when the commands have been
/// sent and no reply is awaited yet, on the task's thread: it must neither allocate, block nor throw.
class StepObserver {
 public:
  virtual ~StepObserver() = default;
  virtual void on_step(const StepRecord& record) noexcept = 0;
};

}  // namespace mrroc
