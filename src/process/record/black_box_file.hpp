#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "config/deployment.hpp"
#include "mrroc/black_box.hpp"
#include "process/record/text_line.hpp"

namespace mrroc::process {

/// The path of a black box of a process: FOLDER/DEPLOYMENT-PROCESS.trace; with number 2, 3, ...
/// FOLDER/DEPLOYMENT-PROCESS-2.trace, ...
std::filesystem::path black_box_path(const std::filesystem::path& folder, const config::Deployment& deployment,
                                     const std::string& process, std::uint64_t number = 1);

/// Writes the steps of a black box as a trace (docs/reference/trace.md) whose first line marks that it begins in the
/// middle of a run. The file is new and has the lowest free number: no black box is overwritten, even when several
/// processes and runs write at the same time. Creates a missing folder. `simulated`: whether the process's clock is.
/// Returns the number. Throws std::runtime_error when it cannot be written; then no file remains.
std::uint64_t write_black_box(const std::filesystem::path& folder, const BlackBox& box,
                              const config::Deployment& deployment, const std::string& process, bool simulated);
/// The same with steps that are already lines of a trace.
std::uint64_t write_black_box(const std::filesystem::path& folder, const std::vector<TextLine>& lines,
                              const config::Deployment& deployment, const std::string& process, bool simulated);

/// The parts of such a file: its first line, and the remark below the lines of a process; both with their ends.
std::string black_box_header(const config::Deployment& deployment, bool simulated);
std::string black_box_remark(const std::string& process, const std::vector<TextLine>& lines);

}  // namespace mrroc::process
