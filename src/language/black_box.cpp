#include "mrroc/black_box.hpp"

#include <stdexcept>
#include <utility>

namespace mrroc {

const StepRecord& BlackBox::at(std::size_t i) const {
  if (i >= size()) throw std::out_of_range("the black box has no such step");
  return steps_[(recorded_ - size() + i) % kSteps];
}

void BlackBox::prepare(std::shared_ptr<const InstructionRecord> instruction) {
  std::erase_if(instructions_, [](const auto& known) { return known.use_count() == 1; });
  for (StepRecord& step : steps_) {
    step.states.reserve(instruction->robots.size());
    step.commands.reserve(instruction->robots.size());
    step.readings.reserve(instruction->sensors.size());
    step.conditions.reserve(instruction->conditions.size());
  }
  instructions_.push_back(std::move(instruction));
}

StepRecord& BlackBox::record(const std::shared_ptr<const InstructionRecord>& instruction) noexcept {
  StepRecord& step = steps_[recorded_++ % kSteps];
  if (step.instruction != instruction) step.instruction = instruction;
  step.states.clear();
  step.commands.clear();
  step.superior.reset();
  step.readings.clear();
  step.conditions.clear();
  return step;
}

}  // namespace mrroc
