#include "cli/run/clock_options.hpp"

namespace mrroc::cli {

namespace {

clock::Mode mode_of(config::ClockMode mode) {
  switch (mode) {
    case config::ClockMode::real:
      return clock::Mode::real;
    case config::ClockMode::paced:
      return clock::Mode::paced;
    case config::ClockMode::lockstep:
      return clock::Mode::lockstep;
  }
  return clock::Mode::lockstep;
}

}  // namespace

clock::HostOptions clock_options(const config::Deployment& deployment, const std::vector<std::string>& processes) {
  clock::HostOptions options;
  options.mode = mode_of(deployment.clock);
  options.period = deployment.servo_period;
  options.participants = processes;
  options.delta_limit = deployment.delta_limit;
  options.live_operator = true;
  return options;
}

}  // namespace mrroc::cli
