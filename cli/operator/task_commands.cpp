#include "cli/operator/task_commands.hpp"

namespace mrroc::cli {

namespace {

links::TaskCommandKind kind_of(const std::string& command) {
  if (command == "pause") return links::TaskCommandKind::pause;
  if (command == "resume") return links::TaskCommandKind::resume;
  if (command == "stop") return links::TaskCommandKind::stop;
  return links::TaskCommandKind::trigger;
}

}  // namespace

void TaskCommands::send(links::TaskCommandKind kind) {
  if (kind == links::TaskCommandKind::stop) stop_sent_ = true;
  const std::lock_guard lock(mutex_);
  mp_.send(kind);
}

void TaskCommands::schedule(clock::ClockHost& clock, const config::Deployment& deployment, OperatorConsole& console) {
  clock.at_tick(0, [this] { send(links::TaskCommandKind::start); });
  for (const config::Event& event : deployment.events) {
    if (event.command == "answer")
      clock.at_tick(event.tick, [&console, &event] { console.answer(event); });
    else if (event.command == "estop" || event.command == "reset")
      clock.at_tick(event.tick, [&console, &event] { console.emergency(event.command); });
    else
      clock.at_tick(event.tick, [this, kind = kind_of(event.command)] { send(kind); });
  }
}

}  // namespace mrroc::cli
