#pragma once

#include <vector>

#include "config/deployment.hpp"
#include "config/table.hpp"

namespace mrroc::config {

/// Reads the tables [[answers]]; `deployment` holds the robots, whose ECPs may ask. Throws ConfigurationError.
std::vector<Answer> read_answers(const Table& root, const Deployment& deployment);

}  // namespace mrroc::config
