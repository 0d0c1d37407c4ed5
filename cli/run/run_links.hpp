#pragma once

#include <functional>
#include <string>

#include "cli/operator/console_input.hpp"
#include "cli/operator/operator_console.hpp"
#include "cli/operator/task_commands.hpp"
#include "clock/clock.hpp"
#include "config/deployment.hpp"
#include "links/exchange/task_superior.hpp"
#include "links/telemetry/status_collector.hpp"
#include "links/transport/domain.hpp"

namespace mrroc::cli {

/// The runner's own links of a deployment: the statuses of its processes, the task in the MP, the operator. Main
/// thread, except the commands.
struct RunLinks {
  /// Construct it when all processes have been started: they would inherit the domain's sockets. Deployment, clock
  /// and input outlive it; `show`: displays a line to the operator.
  RunLinks(const config::Deployment& deployment, const links::DomainOptions& options, clock::Clock& clock,
           ConsoleInput& input, std::function<void(const std::string& line)> show);

  links::Domain domain;
  links::StatusCollector processes;
  links::TaskSuperior mp;
  TaskCommands commands;
  OperatorConsole console;
};

}  // namespace mrroc::cli
