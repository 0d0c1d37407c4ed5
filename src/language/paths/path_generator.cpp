#include "mrroc/generators/path_generator.hpp"

#include "language/paths/path_runner.hpp"

namespace mrroc {

PathGenerator::PathGenerator(Robot& robot, std::string name)
    : Generator(std::move(name)), robot_(&robot), runner_(std::make_unique<PathRunner>(robot)) {}

PathGenerator::~PathGenerator() = default;
PathGenerator::PathGenerator(PathGenerator&&) noexcept = default;
PathGenerator& PathGenerator::operator=(PathGenerator&&) noexcept = default;

void PathGenerator::start() {
  const JointVector joints = runner_->begin();
  if (std::unique_ptr<RobotPath> path = path_from(joints)) runner_->follow(std::move(path));
}

void PathGenerator::resume() { runner_->resume(); }
bool PathGenerator::brake() { return runner_->brake(); }
bool PathGenerator::terminal_condition() { return runner_->over(); }
void PathGenerator::next_state() { runner_->step(); }
double PathGenerator::duration() const noexcept { return runner_->duration(); }

}  // namespace mrroc
