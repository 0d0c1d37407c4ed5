#include "cli/operator/task_records.hpp"

#include <cstdint>
#include <optional>

namespace mrroc::cli {

TaskRecords::TaskRecords(const AgentOrder& order, const std::vector<PlannedProcess>& processes) {
  for (const PlannedProcess& process : processes) {
    if (!process.has_task) continue;
    if (order.record) steps_.emplace(process.name, process::StepRing::create());
    if (order.black_box) last_steps_.emplace(process.name, process::SharedBlackBox::create());
  }
}

void TaskRecords::add_to(process::Arguments& arguments) const {
  if (const auto found = steps_.find(arguments.name); found != steps_.end()) arguments.record_fd = found->second.fd();
  if (const auto found = last_steps_.find(arguments.name); found != last_steps_.end())
    arguments.black_box_fd = found->second.fd();
}

void TaskRecords::send_steps(LineChannel& runner, std::size_t most) {
  for (auto& [task, steps] : steps_) {
    while (runner.waiting() < most) {
      const std::optional<recording::RecordedStep> step = steps.take();
      if (!step) break;
      runner.write("step " + task + " " + to_text(*step));
    }
  }
}

void TaskRecords::send_rest(LineChannel& runner) {
  send_steps(runner, SIZE_MAX);
  for (const auto& [task, steps] : steps_)
    if (steps.ended())
      runner.write("steps_end " + task + " " + std::to_string(steps.added()) + " " + std::to_string(steps.dropped()));
  for (const auto& [task, box] : last_steps_)
    for (const recording::RecordedStep& step : box.steps()) runner.write("last_step " + task + " " + to_text(step));
}

}  // namespace mrroc::cli
