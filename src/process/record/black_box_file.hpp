#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "config/deployment.hpp"
#include "mrroc/black_box.hpp"
#include "process/record/text_line.hpp"

namespace mrroc::process {

/// Where the black box of a process is written: FOLDER/DEPLOYMENT-PROCESS.trace, the next ones, of number 2, 3, ...,
/// FOLDER/DEPLOYMENT-PROCESS-2.trace, ...
std::filesystem::path black_box_path(const std::filesystem::path& folder, const config::Deployment& deployment,
                                     const std::string& process, std::uint64_t number = 1);

/// Writes the steps of a black box as a trace (docs/reference/trace.md) whose first line says that it begins in the
/// middle of a run. The file is a new one, of the least number that is free: no black box is overwritten, whichever
/// processes and runs write at the same time. Makes a missing folder. `simulated`: the clock that the process runs by.
/// Returns the number. Throws std::runtime_error when it cannot be written; then no file remains.
std::uint64_t write_black_box(const std::filesystem::path& folder, const BlackBox& box,
                              const config::Deployment& deployment, const std::string& process, bool simulated);
/// The same with steps that are lines of a trace already.
std::uint64_t write_black_box(const std::filesystem::path& folder, const std::vector<TextLine>& lines,
                              const config::Deployment& deployment, const std::string& process, bool simulated);

}  // namespace mrroc::process
