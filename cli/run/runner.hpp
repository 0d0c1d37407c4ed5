#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "cli/hosts/remote_hosts.hpp"
#include "cli/operator/typed_lines.hpp"
#include "cli/output/black_boxes.hpp"
#include "cli/output/outputs.hpp"
#include "cli/processes/crew.hpp"
#include "cli/processes/process_plan.hpp"
#include "cli/run/domain_lock.hpp"
#include "cli/run/fault_injector.hpp"
#include "cli/run/progress.hpp"
#include "cli/run/run_links.hpp"
#include "cli/run/run_options.hpp"
#include "cli/run/supervisor.hpp"
#include "clock/host.hpp"
#include "config/deployment.hpp"
#include "process/exit_code.hpp"
#include "process/record/text_memory.hpp"
#include "world/mapped_world.hpp"

namespace mrroc::cli {

/// `mrroc run`: starts every process of a deployment, opens the clock when all are ready, starts the MP, lets the
/// supervisor watch over them, and ends every process whatever happens. Main thread.
class Runner {
 public:
  /// Throws std::runtime_error and SystemError when the deployment cannot be started so; nothing has been started then.
  Runner(const config::Deployment& deployment, RunOptions options);
  ~Runner();
  /// The outcome of the task, whatever becomes of what is said about it.
  process::ExitCode run();

 private:
  void start_processes(Outputs& outputs);
  void pass_barrier();
  /// Shakes hands with the MP, and sees meanwhile who dies and what the operator wants; false when all is to end.
  bool connect_to_mp(double deadline);
  void end_processes();
  /// What is done when another host reports something.
  HostListener host_listener(Outputs& outputs);
  /// Writes the trace; the reason why it is not complete becomes that of the run.
  void join_trace(Outputs& outputs);
  /// What all other hosts are told alike.
  AgentOrder common_order() const;
  /// The processes here, and what the other hosts wait for.
  std::vector<std::string> not_ready();

  config::Deployment deployment_;
  RunOptions options_;
  std::vector<PlannedProcess> plan_;
  process::TextMemory text_;  // of the deployment
  BlackBoxes black_boxes_;
  Progress progress_;
  DomainLock domain_lock_;
  clock::ClockHost clock_;
  std::unique_ptr<clock::Clock> operator_clock_;
  std::unique_ptr<world::MappedWorld> world_;
  Crew crew_;
  FaultInjector faults_;
  Supervisor supervisor_;
  std::unique_ptr<RemoteHosts> hosts_;
  TypedLines input_;
  std::unique_ptr<RunLinks> links_;
};

}  // namespace mrroc::cli
