#include "cli/operator/task_records.hpp"

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
  folder_ = pattern;
  for (const std::string& task : tasks_)
    traces_.emplace(task, process::ClaimedFile::create([&](std::uint64_t) { return folder_ / task; }, "the trace"));
}

TaskRecords::~TaskRecords() {
  if (folder_.empty()) return;
  std::error_code none;
  std::filesystem::remove_all(folder_, none);
}

void TaskRecords::add_to(process::Arguments& arguments) const {
  if (std::find(tasks_.begin(), tasks_.end(), arguments.name) == tasks_.end()) return;
  if (const auto trace = traces_.find(arguments.name); trace != traces_.end()) {
    arguments.trace = trace->second.path();
    arguments.trace_fd = trace->second.fd();
  }
  if (const auto found = last_steps_.find(arguments.name); found != last_steps_.end())
    arguments.black_box_fd = found->second.fd();
}

void TaskRecords::send(LineChannel& runner) const {
  for (const auto& [task, steps] : last_steps_)
    for (const process::TextLine& line : steps.lines())
      runner.write("last_step " + task + " " + std::string{line.view()});
  for (const auto& [task, trace] : traces_) {
    const std::string begin = "trace " + task + " ";
    std::ifstream file(trace.path());
    // the last line of a killed process may be incomplete
    for (std::string line; std::getline(file, line) && !file.eof();) runner.write(begin + line);
  }
}

}  // namespace mrroc::cli
