#include "cli/black_boxes.hpp"

#include <system_error>

#include "process/black_box_file.hpp"

namespace mrroc::cli {

namespace {

/// The oldest time there is when there is no such file.
std::filesystem::file_time_type write_time(const std::filesystem::path& file) {
  std::error_code missing;
  const auto time = std::filesystem::last_write_time(file, missing);
  return missing ? std::filesystem::file_time_type::min() : time;
}

}  // namespace

BlackBoxes::BlackBoxes(const std::filesystem::path& folder, const config::Deployment& deployment,
                       const std::vector<PlannedProcess>& processes) {
  if (folder.empty()) return;
  for (const PlannedProcess& process : processes) {
    if (!process.has_task) continue;
    const std::filesystem::path file = process::black_box_path(folder, deployment, process.name);
    files_[file] = write_time(file);
  }
}

std::string BlackBoxes::told() const {
  std::string text;
  for (const auto& [file, before] : files_)
    if (write_time(file) != before) text += (text.empty() ? "; black box: " : ", ") + file.string();
  return text;
}

}  // namespace mrroc::cli
