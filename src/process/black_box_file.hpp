#pragma once

#include <filesystem>
#include <vector>

#include "config/deployment.hpp"
#include "mrroc/black_box.hpp"
#include "process/text_line.hpp"

namespace mrroc::process {

/// Where the black box of a process is written: FOLDER/DEPLOYMENT-PROCESS.trace.
std::filesystem::path black_box_path(const std::filesystem::path& folder, const config::Deployment& deployment,
                                     const std::string& process);

/// Writes the steps of a black box as a trace (docs/trace.md) whose first line says that it begins in the middle of a
/// run; what stood in the file is overwritten, a missing folder is made. `simulated`: the clock that the process runs
/// by. Throws std::runtime_error when it cannot be written.
void write_black_box(const std::filesystem::path& file, const BlackBox& box, const config::Deployment& deployment,
                     const std::string& process, bool simulated);
/// The same with steps that are lines of a trace already.
void write_black_box(const std::filesystem::path& file, const std::vector<TextLine>& lines,
                     const config::Deployment& deployment, const std::string& process, bool simulated);

}  // namespace mrroc::process
