#pragma once

#include <map>
#include <string>
#include <vector>

#include "cli/operator/operator_events.hpp"
#include "cli/operator/questions.hpp"
#include "config/deployment.hpp"
#include "links/wire/process_status.hpp"

namespace mrroc::cli {

/// What an operator sees of a run.
struct OperatorState {
  const config::Deployment& deployment;
  TaskPhase phase = TaskPhase::starting;
  Tick tick = 0;
  double speed = 1;  ///< of the programmed one
  bool emergency_stopped = false;
  std::string commander;                                         ///< empty: command is free
  const std::map<std::string, links::ProcessStatus>& processes;  ///< the last status of each
  const Questions* questions = nullptr;                          ///< null: the links are not open yet
  const std::map<std::string, std::string>& camera_files;        ///< pictures of hardware cameras
  std::vector<std::string> yielded = {};                         ///< robots that follow trajectories
};

/// The state as JSON, the data of `status`: docs/reference/operator.md. Any thread.
std::string to_json(const OperatorState& state);
/// The same data as lines for people; `json` comes from `to_json`. Throws std::runtime_error for another text.
std::string state_text(const std::string& json);

/// One line about a run for `mrroc list`. Throws as `state_text`.
std::string run_line(const std::string& deployment, int pid, const std::string& json);

/// One line of JSON for watchers, with "event" as its first member: "process", "question", "message",
/// "command", "commander", "command_wanted", "end". Any thread.
std::string process_event(const links::ProcessStatus& status);
std::string question_event(const OpenQuestion& question);
std::string message_event(const std::string& text);
/// A command has been performed, given by the client `by`; `phase`: of the task after it.
std::string command_event(const config::Event& event, const std::string& by, TaskPhase phase);
/// `name` holds command; empty: it is free.
std::string commander_event(const std::string& name);
/// The client `by` asks for the command that `holder` holds.
std::string command_wanted_event(const std::string& by, const std::string& holder);
/// A robot is yielded to other programs from now on, or no longer.
std::string yield_event(const std::string& robot, bool open);
std::string end_event(int exit_code, const std::string& reason);
/// The same for people; empty for an event that is not known. Any thread; does not throw.
std::string event_text(const std::string& json);

}  // namespace mrroc::cli
