// The operator's service: trajectories for robots that a task yields.
#include <stdexcept>
#include <utility>

#include "cli/operator/operator_service.hpp"
#include "cli/operator/operator_state.hpp"
#include "config/entries/trajectory_entry.hpp"

namespace mrroc::cli {

namespace {

Refusal refusal_of(TrajectoryState state) noexcept {
  switch (state) {
    case TrajectoryState::refused:
      return Refusal::invalid_trajectory;
    case TrajectoryState::path_tolerance:
      return Refusal::path_tolerance;
    case TrajectoryState::goal_tolerance:
      return Refusal::goal_tolerance;
    case TrajectoryState::cancelled:
      return Refusal::cancelled;
    case TrajectoryState::taken_back:
    case TrajectoryState::withdrawn:
      return Refusal::taken_back;
    default:
      return Refusal::none;
  }
}

const char* text_of(TrajectoryState state) noexcept {
  switch (state) {
    case TrajectoryState::refused:
      return "the trajectory is refused";
    case TrajectoryState::path_tolerance:
      return "the robot was too far from the trajectory and rests";
    case TrajectoryState::goal_tolerance:
      return "the robot rests too far from the end of the trajectory";
    case TrajectoryState::cancelled:
      return "the trajectory has been cancelled";
    default:
      return "the task has taken the robot back";
  }
}

}  // namespace

VerbReply OperatorService::give_trajectory(const VerbRequest& request, std::optional<config::Event>& event) const {
  config::Event given{.command = std::string{request.verb->name}};
  given.order.robot = request.argument("robot");
  std::size_t axes = 0;
  try {
    axes = robots_->axes(given.order.robot);
  } catch (const std::invalid_argument& error) {
    return refuse(Refusal::invalid_argument, error.what());
  }
  if (!trajectories_->yielded(given.order.robot))
    return not_now("no task yields " + given.order.robot, "a Move with External, which takes trajectories");
  if (given.command == "follow") try {
      given.trajectory = config::load_trajectory(std::string{request.argument("file")}, axes);
    } catch (const config::ConfigurationError& error) {
      return refuse(Refusal::invalid_trajectory, error.what());
    }
  event = given;
  return {};
}

void OperatorService::take_report(const TrajectoryReport& report) {
  const std::string robot{report.robot.view()};
  if (report.state == TrajectoryState::yielded || report.state == TrajectoryState::withdrawn)
    publish_(yield_event(robot, trajectories_->yielded(robot)), "");
  if (report.state == TrajectoryState::yielded || report.state == TrajectoryState::begun) return;
  VerbReply reply = done(std::string{find_verb("follow")->effect});
  if (report.state != TrajectoryState::arrived)
    reply = refuse(refusal_of(report.state),
                   text_of(report.state) + (report.text.empty() ? "" : ": " + std::string{report.text.view()}));
  reply.tick = report.tick;
  if (report.state != TrajectoryState::withdrawn) return end_trajectory(report.trajectory, reply);
  std::vector<std::uint64_t> numbers;  // what came to the task after it had withdrawn
  for (const auto& [number, followed] : followed_)
    if (followed.robot == robot && !trajectories_->yielded(robot)) numbers.push_back(number);
  for (const std::uint64_t number : numbers) end_trajectory(number, reply);
}

/// Without a client, an event of the deployment, the watchers see its end.
void OperatorService::end_trajectory(std::uint64_t number, VerbReply reply) {
  const auto followed = followed_.find(number);
  if (followed == followed_.end()) {
    const std::string text = "trajectory " + std::to_string(number) + ": " + to_text(reply);
    publish_(message_event(text), text);
    return;
  }
  reply.id = followed->second.pending.id;
  if (followed->second.pending.reply) followed->second.pending.reply(reply);
  followed_.erase(followed);
}

}  // namespace mrroc::cli
