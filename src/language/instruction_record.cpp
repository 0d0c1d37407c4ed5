// What an instruction records of itself and of its steps.
#include <utility>

#include "language/instruction.hpp"
#include "mrroc/superior.hpp"

namespace mrroc {

void Instruction::begin_record() {
  record_ = std::make_shared<InstructionRecord>();
  record_->is_move = generator_ != nullptr;
  record_->name = generator_ != nullptr ? generator_->name() : condition_->name();
  if (generator_ != nullptr && condition_) record_->until = condition_->name();
  for (const Robot* robot : robots_) record_->robots.push_back(robot->name());
  for (const Sensor* sensor : sensors_)
    record_->sensors.push_back({sensor->name(), sensor->period(), sensor->interactive(), sensor->configuration()});
  for (const Condition* leaf : leaves_) record_->conditions.push_back(leaf->name());
  task_->black_box().prepare(record_);
}

void Instruction::observe(StepEnding ending) {
  if (record_->number == 0) record_->number = task_->begin_instruction();
  StepRecord& record = task_->black_box().record(record_);
  record.step = step_;
  record.held = std::exchange(held_, 0);
  record.obtained = std::exchange(obtained_, false);
  record.tick = newest_tick();
  record.ending = ending;
  record.skew = skew_;
  for (const Robot* robot : robots_) record.states.push_back(robot->state());
  if (!record.last())
    for (Robot* robot : robots_) record.commands.push_back(robot->command());
  if (superior_ != nullptr && !record.last()) record.superior = superior_->command();
  for (const Sensor* sensor : sensors_) record.readings.push_back(sensor->reading());
  if (!record.last() || ending == StepEnding::condition || ending == StepEnding::generator)
    for (const Condition* leaf : leaves_) record.conditions.push_back(leaf->value() ? 1 : 0);
  if (StepObserver* observer = task_->observer()) observer->on_step(record);
}

}  // namespace mrroc
