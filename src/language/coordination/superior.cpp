#include "mrroc/superior.hpp"

namespace mrroc {

void Superior::join() {
  command_ = RobotCommand{};
  pending_ = ended_ = false;
  link_->join();
}

Superior::News Superior::take() {
  if (!link_->take(command_)) return News::nothing;
  pending_ = true;
  if (command_.kind == CommandKind::query) {
    ended_ = false;
    return News::plan;
  }
  if (command_.kind == CommandKind::end) {
    ended_ = true;
    reply(reply_, Coordination::takes_part, {});
    return News::end;
  }
  return command_.kind >= CommandKind::set_tool ? News::change : News::command;
}

void Superior::answer(const RobotState& state) { reply(state, Coordination::takes_part, state.error); }

void Superior::leave(const RobotState& state, const ErrorReport& error) {
  link_->leave();
  if (pending_) reply(state, Coordination::left, error);
}

void Superior::reply(const RobotState& state, Coordination coordination, const ErrorReport& error) {
  reply_ = state;
  reply_.coordination = coordination;
  reply_.error = error;
  pending_ = false;
  link_->reply(reply_);
}

}  // namespace mrroc
