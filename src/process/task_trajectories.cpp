#include "process/task_trajectories.hpp"

#include <algorithm>

namespace mrroc::process {

TaskTrajectories::TaskTrajectories(Process& process)
    : receiver_(process.domain(), process.clock(), process.topic(process.name())) {
  yielded_.reserve(kMostRobots);
  waiting_.reserve(kMostWaiting);
}

bool TaskTrajectories::take(const FixedText<kNameLength>& robot, TrajectoryPart& part) {
  const auto for_robot = [&robot](const TrajectoryPart& each) { return each.robot == robot; };
  if (const auto first = std::find_if(waiting_.begin(), waiting_.end(), for_robot); first != waiting_.end()) {
    part = *first;
    waiting_.erase(first);
    return true;
  }
  while (receiver_.take(part)) {
    if (part.robot == robot) return true;
    if (yields(part.robot) && waiting_.size() < kMostWaiting)
      waiting_.push_back(part);
    else
      refuse(part);
  }
  return false;
}

bool TaskTrajectories::yields(const FixedText<kNameLength>& robot) const noexcept {
  return std::find(yielded_.begin(), yielded_.end(), robot) != yielded_.end();
}

void TaskTrajectories::refuse(const TrajectoryPart& part) {
  if (part.order != TrajectoryOrder::follow || part.begin != 0) return;
  TrajectoryReport refused;
  refused.robot = part.robot;
  refused.trajectory = part.trajectory;
  refused.state = TrajectoryState::refused;
  refused.text.assign("the task did not yield the robot");
  receiver_.report(refused);
}

void TaskTrajectories::report(const TrajectoryReport& report) {
  if (report.state == TrajectoryState::yielded && !yields(report.robot) && yielded_.size() < kMostRobots)
    yielded_.push_back(report.robot);
  if (report.state == TrajectoryState::withdrawn) {
    std::erase(yielded_, report.robot);
    std::erase_if(waiting_, [&report](const TrajectoryPart& part) { return part.robot == report.robot; });
  }
  receiver_.report(report);
}

}  // namespace mrroc::process
