#include "cli/run/run_links.hpp"

#include <utility>

namespace mrroc::cli {

RunLinks::RunLinks(const config::Deployment& deployment, const links::DomainOptions& options, clock::ClockHost& host,
                   clock::Clock& clock, world::WorldMemory* memory, std::function<void(const std::string& line)> show)
    : domain(options),
      processes(domain, deployment.name),
      mp(domain, clock, deployment.name + "/mp", "mp"),
      questions(deployment, domain, clock, std::move(show)),
      robots(deployment, domain, clock),
      trajectories(deployment, domain, clock),
      telemetry(deployment, domain),
      world(memory),
      events({[&host](Tick tick, clock::TickEvents::Callback callback) { host.at_tick(tick, std::move(callback)); },
              [&host] { return host.tick(); }},
             clock.emergency_stop(), mp, questions.links(), robots, trajectories,
             deployment.clock == config::ClockMode::real) {}

}  // namespace mrroc::cli
