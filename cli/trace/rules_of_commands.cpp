// Checks the commands, and that e^{i+1} is where the command leads: f_e* of equation (5), e^{i+1} = e^i of (3).
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "cli/trace/answer.hpp"
#include "cli/trace/words.hpp"

namespace mrroc::cli::trace {

namespace {

/// rad or m. Joints commanded in joint space are met exactly; those at the end of a path in task space, and poses, as
/// exactly as the inverse kinematics allows.
constexpr double kOfPath = 1e-6;

void wait_holds(const Step& step, Findings& findings) {
  if (step.line.is_move) return;
  for (const RobotEntry& robot : step.line.robots)
    if (robot.command && (robot.command->kind != CommandKind::hold || robot.command->relative))
      findings.add(words("robot ", robot.name, " is commanded to move during a Wait"), "hold");
}

void hold_stays(const Step& step, Findings& findings) {
  for (const Answer& answer : answers(step)) {
    if (answer.command.kind != CommandKind::hold || answer.from.moving || answer.after_force) continue;
    if (answer.to.moving) findings.add(words("robot ", answer.to.name, " moves after a hold at rest"), "rest");
    if (answer.to.desired != answer.from.desired)
      findings.add(
          words("desired joints ", words_of(answer.to.desired), " of robot ", answer.to.name, " after a hold at rest"),
          words_of(answer.from.desired));
  }
}

bool near(const Numbers& a, const Numbers& b, double tolerance) {
  const auto close = [tolerance](double x, double y) { return std::abs(x - y) <= tolerance; };
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), close);
}

/// The state is not where the command leads.
bool left_it(const Answer& answer) { return answer.braked() || answer.held_instead() || answer.joined; }

void joint_target(const Step& step, Findings& findings) {
  for (const Answer& answer : answers(step)) {
    const CommandEntry& command = answer.command;
    if (command.kind != CommandKind::joint || answer.by_ecp || left_it(answer)) continue;
    if (command.relative && !answer.continues()) continue;
    Numbers target = command.target;
    if (command.relative && target.size() == answer.from.desired.size())
      for (std::size_t i = 0; i < target.size(); ++i) target[i] += answer.from.desired[i];
    const double tolerance = command.interpolation == Interpolation::task ? kOfPath : 0;
    if (!near(answer.to.desired, target, tolerance))
      findings.add(words("desired joints ", words_of(answer.to.desired), " of robot ", answer.to.name),
                   words(words_of(target), ", as commanded"));
  }
}

Eigen::Isometry3d to_pose(const Numbers& numbers) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translation() = Eigen::Vector3d(numbers[0], numbers[1], numbers[2]);
  pose.linear() = Eigen::Quaterniond(numbers[3], numbers[4], numbers[5], numbers[6]).normalized().toRotationMatrix();
  return pose;
}

void pose_target(const Step& step, Findings& findings) {
  for (const Answer& answer : answers(step)) {
    const CommandEntry& command = answer.command;
    if (command.kind != CommandKind::pose || answer.by_ecp || left_it(answer)) continue;
    if (command.relative && !answer.continues()) continue;
    Eigen::Isometry3d target = to_pose(command.target);
    if (command.relative) target = to_pose(answer.from.desired_pose) * target;
    const Eigen::Isometry3d off = target.inverse() * to_pose(answer.to.desired_pose);
    const double turned = Eigen::AngleAxisd(off.linear()).angle();
    if (!(off.translation().norm() <= kOfPath) || !(turned <= kOfPath))
      findings.add(words("desired_pose=", words_of(answer.to.desired_pose), " of robot ", answer.to.name, ", ",
                         off.translation().norm(), " m and ", turned, " rad off"),
                   "the commanded pose");
  }
}

}  // namespace

Rules rules_of_commands() {
  return {{"wait-holds", "(3) e(i+1) = e(i)", "a Wait commands nothing but hold", wait_holds},
          {"hold-stays", "(3) e(i+1) = e(i)", "a robot at rest that holds stays where it is desired", hold_stays},
          {"joint-target", "(5) e(i+1) = f_e*", "commanded joints are desired at the next step", joint_target},
          {"pose-target", "(5) e(i+1) = f_e*", "a commanded pose is desired at the next step", pose_target}};
}

}  // namespace mrroc::cli::trace
