#pragma once

#include <filesystem>
#include <vector>

#include "config/deployment.hpp"
#include "config/table.hpp"

namespace mrroc::config {

/// Reads the tables [[events]], by tick, those of one tick in file order; `deployment` holds the sensors, to which an
/// `answer` may be sent. Throws ConfigurationError.
std::vector<Event> read_events(const Table& root, const Deployment& deployment);

/// The [[events]] of a file of their own, for this deployment. Throws ConfigurationError.
std::vector<Event> load_events(const std::filesystem::path& file, const Deployment& deployment);

}  // namespace mrroc::config
