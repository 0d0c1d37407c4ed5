#pragma once

#include <array>
#include <cstddef>

#include "mrroc/step_record.hpp"

namespace mrroc {

/// The last steps of a task's Moves and Waits, of all its fibers, in time order. Every error that leaves a Move or
/// Wait carries a copy (`Error::black_box`), and the task writes it to disk when it fails. Move and Wait record into
/// the black box of their task (`Task::black_box`), without allocation or lock at a step; a copy does not change.
/// Task's thread; a constant copy: any thread.
class BlackBox {
 public:
  /// Number of steps that are kept.
  static constexpr std::size_t kSteps = 50;

  bool empty() const noexcept { return recorded_ == 0; }
  /// Number of steps in it: at most kSteps.
  std::size_t size() const noexcept { return recorded_ < kSteps ? static_cast<std::size_t>(recorded_) : kSteps; }
  /// The `i`-th step, the oldest first; throws std::out_of_range when there is no such step.
  const StepRecord& at(std::size_t i) const;
  /// The newest step; throws std::out_of_range when the box is empty.
  const StepRecord& newest() const { return at(size() - 1); }
  /// Number of steps since the task began, including those that have been overwritten.
  std::uint64_t recorded() const noexcept { return recorded_; }

  // ---- used by Move and Wait
  /// Reserves memory for the steps of an instruction; called before its first step. Allocates.
  void prepare(std::shared_ptr<const InstructionRecord> instruction);
  /// The record of the next step, which replaces the oldest one; the caller fills it. The instruction must have been
  /// prepared. Neither allocates nor frees.
  StepRecord& record(const std::shared_ptr<const InstructionRecord>& instruction) noexcept;

 private:
  std::array<StepRecord, kSteps> steps_;
  std::uint64_t recorded_ = 0;
  /// Keeps the instructions alive while a step may refer to them, so that overwriting a step frees nothing.
  std::vector<std::shared_ptr<const InstructionRecord>> instructions_;
};

}  // namespace mrroc
