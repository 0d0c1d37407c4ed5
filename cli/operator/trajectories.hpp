#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "clock/clock.hpp"
#include "config/deployment.hpp"
#include "links/trajectory/trajectory_sender.hpp"
#include "links/transport/domain.hpp"
#include "mrroc/joint_trajectory.hpp"

namespace mrroc::cli {

/// The runner's way of trajectories to the tasks. A robot may be yielded by its ECP or by the MP, so both receive every
/// part, in the same order; the one that does not yield it refuses it, which is no news.
class Trajectories {
 public:
  /// Opens the links of all task processes. All outlive it.
  Trajectories(const config::Deployment& deployment, links::Domain& domain, clock::Clock& clock);

  // ---- by the thread of the events, one at a time
  /// The number of a new trajectory.
  std::uint64_t begin() noexcept { return ++last_; }
  static std::size_t parts_of(const JointTrajectory& trajectory) noexcept;
  /// Sends part `index` of it. Throws as links::Writer.
  void send(const std::string& robot, std::uint64_t number, const JointTrajectory& trajectory, std::size_t index);
  /// Cancels what the robot follows, but no trajectory that begins later.
  void cancel(const std::string& robot);

  // ---- main thread
  /// Takes the reports that have come, but those of tasks that do not yield the robot.
  std::vector<TrajectoryReport> take_reports();
  /// Whether a task yields the robot, by its reports so far.
  bool yielded(const std::string& robot) const { return yielding_.contains(robot); }
  /// The robots that are yielded, by name.
  std::vector<std::string> yielded() const;

 private:
  void send(const TrajectoryPart& part);

  std::map<std::string, std::unique_ptr<links::TrajectorySender>> links_;  // by process
  std::map<std::string, std::set<std::string>> yielding_;                  // processes, by robot
  std::uint64_t last_ = 0;
};

}  // namespace mrroc::cli
