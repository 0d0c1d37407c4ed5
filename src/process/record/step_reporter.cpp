#include "process/record/step_reporter.hpp"

#include <algorithm>

#include "process/record/step_encoder.hpp"

namespace mrroc::process {

StepReporter::StepReporter(Process& process) : process_(process) {
  if (const int fd = process.arguments().black_box_fd; fd >= 0) last_steps_.emplace(SharedBlackBox::attach(fd));
  const Arguments& arguments = process.arguments();
  if (arguments.record_fd >= 0) ring_.emplace(StepRing::attach(arguments.record_fd));
}

StepReporter::~StepReporter() {
  if (ring_) ring_->end();
}

void StepReporter::on_step(const StepRecord& record) noexcept {
  process_.faults().count_step(process_.name(), ++steps_, process_.clock().tick(), process_.clock());
  process_.status().step(record.instruction->number, record.instruction->name, record.step);
  if (record.states.size() > 1 && !record.last()) {
    ++counters_.common_steps;
    counters_.skew_ticks = std::max<std::uint64_t>(counters_.skew_ticks, record.skew);
    process_.status().counters(counters_);
  }
  if (last_steps_ || ring_) pass_on(record);
}

void StepReporter::pass_on(const StepRecord& record) noexcept {
  const Tick now = process_.clock().tick();
  encode_step(step_, process_.deployment(), process_.name(), record);
  if (last_steps_) last_steps_->record(now, step_);
  if (ring_) ring_->add(now, step_, process_.clock().simulated());
}

}  // namespace mrroc::process
