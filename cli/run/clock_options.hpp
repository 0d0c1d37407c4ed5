#pragma once

#include <string>
#include <vector>

#include "clock/host.hpp"
#include "config/deployment.hpp"

namespace mrroc::cli {

/// The clock options of a deployment with these processes as participants.
clock::HostOptions clock_options(const config::Deployment& deployment, const std::vector<std::string>& processes);

}  // namespace mrroc::cli
