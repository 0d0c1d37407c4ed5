#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "config/deployment.hpp"

namespace mrroc::cli {

/// The table [sim.errors] that `mrroc run --errors NAME --seed SEED` adds to the text of a deployment file, which
/// `deployment` was read from; messages name it `file`. NAME: a set of share/mrroc/sim/errors, or a path from the
/// present folder. Throws ConfigurationError that names the option: the deployment simulates no world, or has this
/// table already; there is no such set. Main thread.
std::string errors_table(const std::filesystem::path& file, const config::Deployment& deployment,
                         const std::string& name, std::uint32_t seed);

}  // namespace mrroc::cli
