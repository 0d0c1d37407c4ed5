#pragma once

#include <filesystem>
#include <list>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cli/hosts/remote_hosts.hpp"
#include "cli/operator/event_notes.hpp"
#include "cli/operator/operator_service.hpp"
#include "cli/operator/socket/operator_socket.hpp"
#include "cli/operator/terminal/console_input.hpp"
#include "cli/operator/terminal/operator_console.hpp"
#include "cli/output/black_boxes.hpp"
#include "cli/output/outputs.hpp"
#include "cli/processes/camera_memories.hpp"
#include "cli/processes/process_group.hpp"
#include "cli/processes/process_plan.hpp"
#include "cli/record/recorder.hpp"
#include "cli/run/domain_lock.hpp"
#include "cli/run/fault_injector.hpp"
#include "cli/run/progress.hpp"
#include "cli/run/run_links.hpp"
#include "cli/run/run_options.hpp"
#include "cli/run/side_process.hpp"
#include "cli/run/supervisor.hpp"
#include "clock/host.hpp"
#include "config/deployment.hpp"
#include "process/exit_code.hpp"
#include "process/record/text_memory.hpp"
#include "world/mapped_world.hpp"

namespace mrroc::cli {

/// `mrroc run`: starts every process of a deployment, opens the clock when all are ready, starts the MP, lets the
/// supervisor watch them, and ends every process in every case. Main thread.
class Runner {
 public:
  /// Throws std::runtime_error and SystemError when the deployment cannot be started; then nothing has been started.
  Runner(const config::Deployment& deployment, RunOptions options);
  ~Runner();
  /// The outcome of the task, even when its output cannot be written.
  process::ExitCode run();

 private:
  /// Throws std::runtime_error when the folder that the caller has named cannot be written; warns of the default one.
  void check_black_boxes();
  void open_operator(const Outputs& outputs);
  /// Starts the panel's server and the bridge to ROS 2 where they are wanted.
  void open_sides();
  /// Starts one and waits until it serves; the run fails when it does not.
  void open_side(const std::string& name, const std::string& program, std::vector<std::string> words);
  void start_processes(Outputs& outputs);
  void pass_barrier();
  /// Connects to the MP and the EDPs, and watches processes and the operator meanwhile; returns false when the run must
  /// end.
  bool connect_to_mp(double deadline);
  /// Ends the run: `missing` was not ready within the deployment's start time-out.
  void not_ready_in_time(const std::string& missing);
  void end_processes();
  /// Callbacks for reports of other hosts.
  HostListener host_listener();
  /// Closes the recording; if it is incomplete, the reason becomes the reason of the run's failure.
  void close_recording(Outputs& outputs);
  /// The run's failure, or after another one only a message: an output is incomplete.
  void fail_by_output(process::ExitCode code, const std::string& reason);
  /// The part of the order that is the same for all other hosts.
  AgentOrder common_order() const;
  /// The processes here that are not ready, and those of the other hosts.
  std::vector<std::string> not_ready();

  config::Deployment deployment_;
  RunOptions options_;
  std::vector<PlannedProcess> plan_;
  process::TextMemory text_;  // of the deployment
  BlackBoxes black_boxes_;
  CameraMemories cameras_;
  Progress progress_;
  DomainLock domain_lock_;
  clock::ClockHost clock_;
  std::unique_ptr<clock::Clock> operator_clock_;
  std::unique_ptr<world::MappedWorld> world_;
  ProcessGroup group_;
  FaultInjector faults_;
  OperatorService service_;
  Supervisor supervisor_;
  std::unique_ptr<RemoteHosts> hosts_;
  ConsoleInput input_;
  std::optional<EventNotes> notes_;
  std::optional<record::Recorder> recorder_;
  std::list<SideProcess> sides_;  // end after the socket
  std::optional<OperatorSocket> socket_;
  std::unique_ptr<RunLinks> links_;
  std::optional<OperatorConsole> console_;
};

}  // namespace mrroc::cli
