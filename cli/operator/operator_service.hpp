#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "cli/operator/command_holder.hpp"
#include "cli/operator/operator_events.hpp"
#include "cli/operator/questions.hpp"
#include "cli/operator/robot_orders.hpp"
#include "cli/operator/trajectories.hpp"
#include "cli/operator/verb_reply.hpp"
#include "cli/operator/verb_request.hpp"
#include "cli/operator/watching/watched_states.hpp"
#include "config/deployment.hpp"
#include "links/wire/process_status.hpp"

namespace mrroc::cli {

/// Executes the operator's verbs for all clients, one commander at a time, and replies when a command has taken effect
/// or why it did not. The verbs act through OperatorEvents: they reach the processes at tick boundaries. Main thread.
class OperatorService {
 public:
  using Reply = std::function<void(const VerbReply& reply)>;
  /// Receives what every watching client sees, one line of JSON, and its text for the run's own terminal; the text is
  /// empty for what the terminal shows in another way.
  using Publish = std::function<void(const std::string& json, const std::string& text)>;
  using Note = std::function<void(const config::Event& event)>;

  /// `deployment` outlives it.
  explicit OperatorService(const config::Deployment& deployment);

  /// Before this call, while the processes are being started, `status`, `echo`, `command` and `release` work, and
  /// `stop` and `estop` end the run. All outlive the service's last call.
  void connect(OperatorEvents& events, Questions& questions, RobotOrders& robots, Trajectories& trajectories);
  void publish_to(Publish publish) { publish_ = std::move(publish); }
  /// Receives every command that has taken effect, in order; it may throw, out of `poll`.
  void note_to(Note note) { note_ = std::move(note); }
  /// The files with the pictures of hardware cameras, for `status`.
  void show_cameras(std::map<std::string, std::string> files) { camera_files_ = std::move(files); }
  /// The effect of `stop` while the processes are being started.
  void end_with(std::function<void()> end) { end_ = std::move(end); }

  /// Writes the last steps of the tasks to this file for `record`, and returns what was written. Throws
  /// std::logic_error when there is nothing to be written, std::runtime_error when the file cannot be written.
  using Record = std::function<std::string(const std::string& file)>;
  void record_with(Record record) { record_ = std::move(record); }

  /// Executes a request; calls `reply`, which may be empty, at once or from a later `poll`.
  void request(const OperatorClient& client, const VerbRequest& request, Reply reply);
  /// The client has disconnected: it gives command back and gets no more replies.
  void leave(const OperatorClient& client);
  /// Replies to the commands that have taken effect, notes them, and publishes new questions.
  void poll();
  /// The run has ended: refuses all commands that wait for their tick, and publishes the end.
  void end(int exit_code, const std::string& reason);

  /// The last status of a process; a message or a line of a process: for the watchers and for `status`.
  void update(const links::ProcessStatus& status);
  void message(const std::string& line);

  /// Whether live answers are possible under the deployment's clock.
  bool may_answer() const noexcept { return deployment_.clock != config::ClockMode::lockstep; }
  TaskPhase phase() const noexcept { return events_ == nullptr ? TaskPhase::starting : events_->phase(); }

 private:
  struct Pending {
    OperatorClient client;
    Reply reply;
    std::optional<std::int64_t> id;
  };

  struct Followed {
    std::string robot;
    Pending pending;
  };

  struct Ordered {
    std::uint64_t number = 0;
    std::string command;
    Pending pending;
  };

  /// The reply, or the command to be given, in `event`.
  VerbReply execute(const OperatorClient& client, const VerbRequest& request, std::optional<config::Event>& event);
  VerbReply take_command(const OperatorClient& client);
  VerbReply give_answer(const VerbRequest& request, std::optional<config::Event>& event);
  static VerbReply give_speed(const VerbRequest& request, std::optional<config::Event>& event);
  VerbReply give_order(const VerbRequest& request, std::optional<config::Event>& event) const;
  /// Why another order is refused while the robot has not answered the last one; ok when it may be given.
  VerbReply check_answered(const config::Event& event) const;
  void order_given(const OperatorEvents::Performed& performed, Pending pending);
  void take_answer(const RobotOrders::Answer& answer);
  // ---- in operator_service_trajectories.cpp
  VerbReply give_trajectory(const VerbRequest& request, std::optional<config::Event>& event) const;
  void take_report(const TrajectoryReport& report);
  void end_trajectory(std::uint64_t number, VerbReply reply);

  VerbReply report() const;
  VerbReply record(const OperatorClient& client, const std::string& file) const;
  /// Why the verb has no effect in the present phase; ok when it has one.
  VerbReply check_phase(std::string_view verb) const;
  void reply_to(const OperatorEvents::Performed& performed);
  void report_refused(const OperatorEvents::Performed& performed);
  void reply_to_resets();
  void publish_holder();

  const config::Deployment& deployment_;
  OperatorEvents* events_ = nullptr;
  Questions* questions_ = nullptr;
  RobotOrders* robots_ = nullptr;
  Trajectories* trajectories_ = nullptr;
  Publish publish_ = [](const std::string&, const std::string&) {};
  Note note_;
  std::function<void()> end_ = [] {};
  Record record_;
  CommandHolder holder_;
  std::map<std::uint64_t, Pending> pending_;      // by ticket
  std::vector<std::pair<Pending, Tick>> resets_;  // performed, but perhaps not on every host
  std::map<std::string, Ordered> ordered_;        // by robot: the order without an answer so far
  std::map<std::uint64_t, Followed> followed_;    // by number: trajectories that have not ended
  std::map<std::string, links::ProcessStatus> statuses_;
  std::map<std::string, std::string> camera_files_;
  std::string published_question_;
};

}  // namespace mrroc::cli
