#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "config/deployment.hpp"
#include "mrroc/black_box.hpp"
#include "recording/recorded_step.hpp"

namespace mrroc::process {

/// The path of a black box of a process: FOLDER/DEPLOYMENT-PROCESS.mcap; with number 2, 3, ...
/// FOLDER/DEPLOYMENT-PROCESS-2.mcap, ...
std::filesystem::path black_box_path(const std::filesystem::path& folder, const config::Deployment& deployment,
                                     const std::string& process, std::uint64_t number = 1);

/// The steps of a black box, as a recording has them.
std::vector<recording::RecordedStep> encoded(const BlackBox& box, const config::Deployment& deployment,
                                             const std::string& process);

/// Writes the last steps of a process as a recording (recording::write_last_steps). The file is new and has the lowest
/// free number: no black box is overwritten, even when several processes and runs write at the same time. Creates a
/// missing folder. `text`: of the deployment; `simulated`: whether the process's clock is. Returns the number. Throws
/// std::runtime_error when it cannot be written; then no file remains.
std::uint64_t write_black_box(const std::filesystem::path& folder, const std::vector<recording::RecordedStep>& steps,
                              const config::Deployment& deployment, const std::string& text, const std::string& process,
                              bool simulated);

}  // namespace mrroc::process
