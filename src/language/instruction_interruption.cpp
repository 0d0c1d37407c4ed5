// The ways in which an instruction is interrupted, and how its robots come to rest then.
#include <algorithm>
#include <utility>

#include "language/instruction.hpp"
#include "mrroc/stopped.hpp"

namespace mrroc {

bool Instruction::operator_ends_it() {
  OperatorRequest request = task_->operator_request();
  if (request == OperatorRequest::pause && superior_ != nullptr) request = OperatorRequest::none;  // the MP pauses
  // robots that move together are brought to rest on their common way before their Move ends
  const bool ends = request == OperatorRequest::stop || request == OperatorRequest::end_motion;
  if (ends && together() && ending_ != OperatorRequest::stop) ending_ = request;
  const bool brake = request == OperatorRequest::pause || ending_ != OperatorRequest::none;
  const bool comes_to_rest = leads_to_rest();
  if (brake && !braking_ && generator_ != nullptr && moving()) begin_braking();
  // a pause that ends early still leads to rest: the generator continues from there
  if (braking_ && comes_to_rest && (brake || request == OperatorRequest::none) && moving() &&
      braking_steps_++ < kMostBrakingSteps)
    return false;
  if (ending_ != OperatorRequest::none) request = std::exchange(ending_, OperatorRequest::none);
  if (request == OperatorRequest::pause || braking_) request = hold_until_resumed(request);
  if (request == OperatorRequest::stop) throw Stopped{};
  return request == OperatorRequest::end_motion;
}

bool Instruction::moving() const noexcept {
  return std::any_of(robots_.begin(), robots_.end(), [](const Robot* robot) { return !robot->state().at_rest(); });
}

bool Instruction::together() const noexcept {
  // an ECP that takes part gets the stop itself and leaves
  const auto coordinated = [](const Robot* robot) { return robot->state().coordination != Coordination::none; };
  return robots_.size() > 1 && superior_ == nullptr && std::none_of(robots_.begin(), robots_.end(), coordinated);
}

void Instruction::begin_braking() {
  if (speed_.acts()) {
    braking_ = halting_ = speed_.can_halt();
    return;
  }
  braking_ = generator_->brake();
  if (!braking_ && together()) braking_ = halting_ = speed_.can_halt();
}

bool Instruction::leads_to_rest() const noexcept { return !halting_ || (speed_.can_halt() && speed_.stretches()); }

void Instruction::end_braking() noexcept {
  braking_ = halting_ = false;
  braking_steps_ = 0;
}

void Instruction::brake_together() {
  const auto reports = [](const Robot* robot) { return robot->state().error.error_class != ErrorClass::none; };
  if (!together() || !leads_ || !moving()) return;
  try {
    if (!braking_) begin_braking();
    while (braking_ && braking_steps_++ < kMostBrakingSteps && moving() &&
           std::none_of(robots_.begin(), robots_.end(), reports)) {
      if (speed_.due() && generator_->terminal_condition()) return;
      write_next_state();
      if (!leads_to_rest()) return;
      send(++step_);
      receive(step_);
    }
  } catch (const Error&) {  // the generator cannot lead them on
  }
}

OperatorRequest Instruction::hold_until_resumed(OperatorRequest request) {
  while (request == OperatorRequest::pause) {
    hold();
    request = task_->operator_request();
  }
  if (request == OperatorRequest::none && generator_ != nullptr) {
    come_to_rest();
    resume_generator();
  }
  end_braking();
  return request;
}

void Instruction::hold() {
  for (Robot* robot : robots_) robot->reset_command(CommandKind::hold);
  ++held_;
  send(0);  // step 0: every reading is due, so that the motion resumes with new ones
  receive(0);
  throw_reported_errors();
}

void Instruction::come_to_rest() {
  while (moving()) hold();
}

}  // namespace mrroc
