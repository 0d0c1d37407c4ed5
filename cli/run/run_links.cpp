#include "cli/run/run_links.hpp"

#include <utility>

namespace mrroc::cli {

RunLinks::RunLinks(const config::Deployment& deployment, const links::DomainOptions& options, clock::Clock& clock,
                   ConsoleInput& input, std::function<void(const std::string& line)> show)
    : domain(options),
      processes(domain, deployment.name),
      mp(domain, clock, deployment.name + "/mp", "mp"),
      commands(mp),
      console(deployment, domain, clock, input, std::move(show)) {}

}  // namespace mrroc::cli
