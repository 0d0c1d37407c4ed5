#pragma once

#include <array>
#include <cstddef>

#include "mrroc/step_record.hpp"

namespace mrroc {

/// The last steps of a task's Moves and Waits, of all its strands, as they came: what every error that leaves one of
/// them carries (`Error::black_box`), and what is written to disk when a task fails. Move and Wait record into that of
/// their task (`Task::black_box`), which costs no allocation and no lock at a step; a copy stays as it is. Task's
/// thread; a copy that no one changes: any thread.
class BlackBox {
 public:
  /// How many steps are kept.
  static constexpr std::size_t kSteps = 50;

  bool empty() const noexcept { return recorded_ == 0; }
  /// Steps that are in it: at most kSteps.
  std::size_t size() const noexcept { return recorded_ < kSteps ? static_cast<std::size_t>(recorded_) : kSteps; }
  /// The `i`-th of them, the oldest first; std::out_of_range when there is none.
  const StepRecord& at(std::size_t i) const;
  /// The newest; std::out_of_range when it is empty.
  const StepRecord& newest() const { return at(size() - 1); }
  /// Steps since the task began: those that are not in it any more, too.
  std::uint64_t recorded() const noexcept { return recorded_; }

  // ---- used by Move and Wait
  /// Makes room for the steps of an instruction; to be called before its first one. Allocates.
  void prepare(std::shared_ptr<const InstructionRecord> instruction);
  /// The record of the next step, in place of the oldest one: for the caller to fill. The instruction has been
  /// prepared. Neither allocates nor frees.
  StepRecord& record(const std::shared_ptr<const InstructionRecord>& instruction) noexcept;

 private:
  std::array<StepRecord, kSteps> steps_;
  std::uint64_t recorded_ = 0;
  /// Keeps them alive while a step may refer to them, so that overwriting a step frees nothing.
  std::vector<std::shared_ptr<const InstructionRecord>> instructions_;
};

}  // namespace mrroc
