#include "cli/task_records.hpp"

#include <stdlib.h>

#include <algorithm>
#include <fstream>
#include <stdexcept>
#include <system_error>

namespace mrroc::cli {

TaskRecords::TaskRecords(const AgentOrder& order, const std::vector<PlannedProcess>& processes) {
  for (const PlannedProcess& process : processes) {
    if (!process.has_task) continue;
    tasks_.push_back(process.name);
    if (order.black_box) last_steps_.emplace(process.name, process::SharedBlackBox::create());
  }
  if (!order.trace) return;
  std::string pattern = std::filesystem::temp_directory_path() / "mrroc_agent_XXXXXX";
  if (mkdtemp(pattern.data()) == nullptr) throw std::runtime_error("no folder for traces");
  traces_ = pattern;
}

TaskRecords::~TaskRecords() {
  if (traces_.empty()) return;
  std::error_code none;
  std::filesystem::remove_all(traces_, none);
}

void TaskRecords::add_to(process::Arguments& arguments) const {
  if (std::find(tasks_.begin(), tasks_.end(), arguments.name) == tasks_.end()) return;
  if (!traces_.empty()) arguments.trace = traces_ / arguments.name;
  if (const auto found = last_steps_.find(arguments.name); found != last_steps_.end())
    arguments.black_box_fd = found->second.fd();
}

void TaskRecords::send(LineChannel& runner) const {
  for (const auto& [task, steps] : last_steps_)
    for (const process::TextLine& line : steps.lines())
      runner.write("last_step " + task + " " + std::string{line.view()});
  if (traces_.empty()) return;
  for (const std::string& task : tasks_) {
    std::ifstream file(traces_ / task);
    // of one that was killed the last line may be half a line
    for (std::string line; std::getline(file, line) && !file.eof();) runner.write("trace " + task + " " + line);
  }
}

}  // namespace mrroc::cli
