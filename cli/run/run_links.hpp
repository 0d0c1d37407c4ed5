#pragma once

#include <functional>
#include <string>

#include "cli/operator/operator_events.hpp"
#include "cli/operator/questions.hpp"
#include "cli/operator/robot_orders.hpp"
#include "cli/operator/trajectories.hpp"
#include "cli/operator/watching/telemetry_feed.hpp"
#include "cli/operator/watching/world_feed.hpp"
#include "clock/clock.hpp"
#include "clock/host.hpp"
#include "config/deployment.hpp"
#include "links/exchange/task_superior.hpp"
#include "links/telemetry/status_collector.hpp"
#include "links/transport/domain.hpp"

namespace mrroc::cli {

/// The runner's own links of a deployment: the statuses of its processes, the task in the MP, the operator. Main
/// thread, except the events.
struct RunLinks {
  /// Construct it when all processes have been started: they would inherit the domain's sockets. Deployment, clocks
  /// and `memory` (of the simulated world here, or null) outlive it; `show`: displays a line to the operator.
  RunLinks(const config::Deployment& deployment, const links::DomainOptions& options, clock::ClockHost& host,
           clock::Clock& clock, world::WorldMemory* memory, std::function<void(const std::string& line)> show);

  links::Domain domain;
  links::StatusCollector processes;
  links::TaskSuperior mp;
  Questions questions;
  RobotOrders robots;
  Trajectories trajectories;
  TelemetryFeed telemetry;
  WorldFeed world;
  OperatorEvents events;
};

}  // namespace mrroc::cli
