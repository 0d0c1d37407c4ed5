#include "cli/operator/trajectories.hpp"

#include <algorithm>

namespace mrroc::cli {

namespace {

bool of_yielding(TrajectoryState state) noexcept {
  return state == TrajectoryState::yielded || state == TrajectoryState::withdrawn;
}

}  // namespace

Trajectories::Trajectories(const config::Deployment& deployment, links::Domain& domain, clock::Clock& clock) {
  const auto open = [&](const std::string& process) {
    links_[process] = std::make_unique<links::TrajectorySender>(domain, clock, deployment.name + "/" + process);
  };
  open("mp");
  for (const config::RobotEntry& robot : deployment.robots) open(robot.name);
}

std::size_t Trajectories::parts_of(const JointTrajectory& trajectory) noexcept {
  return (trajectory.numbers().size() + TrajectoryPart::kNumbers - 1) / TrajectoryPart::kNumbers;
}

void Trajectories::send(const std::string& robot, std::uint64_t number, const JointTrajectory& trajectory,
                        std::size_t index) {
  const auto numbers = trajectory.numbers();
  TrajectoryPart part;
  part.robot.assign(robot);
  part.trajectory = number;
  part.size = static_cast<std::uint32_t>(numbers.size());
  part.begin = static_cast<std::uint32_t>(index * TrajectoryPart::kNumbers);
  part.count = static_cast<std::uint16_t>(std::min(TrajectoryPart::kNumbers, numbers.size() - part.begin));
  std::copy_n(numbers.begin() + part.begin, part.count, part.numbers.begin());
  send(part);
}

void Trajectories::cancel(const std::string& robot) {
  TrajectoryPart part;
  part.robot.assign(robot);
  part.order = TrajectoryOrder::cancel;
  part.trajectory = last_;
  send(part);
}

void Trajectories::send(const TrajectoryPart& part) {
  const auto own = links_.find(std::string{part.robot.view()});
  if (own != links_.end()) own->second->send(part);
  links_.at("mp")->send(part);
}

std::vector<TrajectoryReport> Trajectories::take_reports() {
  std::vector<TrajectoryReport> reports;
  TrajectoryReport report;
  for (const auto& [process, link] : links_) {
    while (link->take(report)) {
      const std::string robot{report.robot.view()};
      if (report.state == TrajectoryState::yielded) yielding_[robot].insert(process);
      const auto yielding = yielding_.find(robot);
      const bool yields = yielding != yielding_.end() && yielding->second.contains(process);
      if (report.state == TrajectoryState::withdrawn && yields) yielding->second.erase(process);
      if (yielding != yielding_.end() && yielding->second.empty()) yielding_.erase(yielding);
      if (yields || of_yielding(report.state) || !yielded(robot)) reports.push_back(report);
    }
  }
  return reports;
}

std::vector<std::string> Trajectories::yielded() const {
  std::vector<std::string> names;
  for (const auto& [robot, processes] : yielding_) names.push_back(robot);
  return names;
}

}  // namespace mrroc::cli
