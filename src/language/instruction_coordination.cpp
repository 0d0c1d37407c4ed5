// Equation (11) in an instruction: in an ECP the step that follows the MP's, in the MP the signs that an ECP needs.
#include <algorithm>

#include "language/instruction.hpp"
#include "language/joints/bring_to_rest.hpp"
#include "mrroc/superior.hpp"

namespace mrroc {

namespace {

ErrorReport report_of(const Error& error) {
  ErrorReport report;
  report.error_class = error.error_class();
  report.code = error.code();
  report.detail.assign(error.detail());
  return report;
}

bool takes_part(const Robot* robot) noexcept { return robot->state().coordination == Coordination::takes_part; }

}  // namespace

void Instruction::join_superior() {
  superior_ = generator_ != nullptr ? generator_->followed() : nullptr;
  if (superior_ == nullptr) return;
  if (robots_.size() != 1)
    throw NonFatalError(ErrorCode::invalid_argument,
                        generator_->name() + " with " + std::to_string(robots_.size()) +
                            " robots, expected the one of this ECP: the MP takes part in the Move",
                        {task_->process_name(), "", 0, task_->tick()});
  superior_->join();
}

void Instruction::end_after(const Error& error) {
  if (error.error_class() != ErrorClass::system) {  // else an exchange may be under way
    brake_together();
    bring_to_rest(robots_);
    try {
      end_coordination();
    } catch (const Error&) {  // the next instruction throws it again
    }
  }
  leave_superior(&error);
}

void Instruction::leave_superior(const Error* error) {
  if (superior_ != nullptr) superior_->leave(robots_[0]->state(), error != nullptr ? report_of(*error) : ErrorReport{});
}

bool Instruction::superior_commands() {
  Robot& robot = *robots_[0];
  switch (superior_->take()) {
    case Superior::News::command:
    case Superior::News::end:
      return true;
    case Superior::News::plan:
      obtain_initial_state();
      obtained_ = true;
      superior_->answer(robot.state());
      throw_reported_errors();
      generator_->resume();
      return false;
    case Superior::News::change:
      robot.command() = superior_->command();
      robot.send();
      robot.receive();
      obtained_ = true;
      superior_->answer(robot.state());
      return false;
    case Superior::News::nothing:
      superior_->wait();
      return false;
  }
  return false;
}

void Instruction::write_with_superior() {
  RobotCommand& command = robots_[0]->command();
  const RobotCommand& wished = superior_->command();
  robots_[0]->reset_command(CommandKind::hold);
  command.motion_steps = wished.motion_steps;
  command.reply_step = wished.reply_step;
  command.start_tick = wished.start_tick;
  command.with_outputs = wished.with_outputs;
  command.outputs = wished.outputs;
  if (wished.kind != CommandKind::hold) generator_->next_state();
  command.stop = wished.stop;
}

void Instruction::obtain_if_coordinated() {
  if (std::none_of(robots_.begin(), robots_.end(), takes_part)) return;
  obtain_initial_state();
  obtained_ = true;
  throw_reported_errors();
}

void Instruction::end_coordination() {
  if (generator_ == nullptr) return;  // a Wait only holds: the motion of an ECP continues after it
  std::vector<Robot*> coordinated;
  std::copy_if(robots_.begin(), robots_.end(), std::back_inserter(coordinated), takes_part);
  for (Robot* robot : coordinated) robot->reset_command(CommandKind::end);
  for (Robot* robot : coordinated) robot->send();
  for (Robot* robot : coordinated) {  // the reply is of an ECP, which may do something else by now
    const RobotState last = robot->state();
    robot->receive();
    robot->exchanged_state() = last;
  }
}

}  // namespace mrroc
