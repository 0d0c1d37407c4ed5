#pragma once

#include <vector>

#include "links/trajectory/trajectory_receiver.hpp"
#include "mrroc/trajectory_link.hpp"
#include "process/process.hpp"

namespace mrroc::process {

/// The trajectories that come to a task process, for all of its robots. What comes for a robot that the task does not
/// yield is refused. Task's thread.
class TaskTrajectories final : public TrajectoryLink {
 public:
  explicit TaskTrajectories(Process& process);

  /// As TrajectoryReceiver::connect.
  void connect(double timeout) { receiver_.connect(timeout); }
  bool take(const FixedText<kNameLength>& robot, TrajectoryPart& part) override;
  void report(const TrajectoryReport& report) override;

 private:
  static constexpr std::size_t kMostRobots = 64, kMostWaiting = 32;

  bool yields(const FixedText<kNameLength>& robot) const noexcept;
  void refuse(const TrajectoryPart& part);

  links::TrajectoryReceiver receiver_;
  std::vector<FixedText<kNameLength>> yielded_;
  std::vector<TrajectoryPart> waiting_;  // for another robot of these
};

}  // namespace mrroc::process
