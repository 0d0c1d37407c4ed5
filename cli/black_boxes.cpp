#include "cli/black_boxes.hpp"

#include <stdexcept>
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
                       const std::vector<PlannedProcess>& processes)
    : deployment_(deployment) {
  if (folder.empty()) return;
  for (const PlannedProcess& process : processes) {
    if (!process.has_task) continue;
    const std::filesystem::path file = process::black_box_path(folder, deployment, process.name);
    Box& box = boxes_.emplace_back(Box{process.name, file, write_time(file), {}, {}});
    if (process.host.empty()) box.last_steps.emplace(process::SharedBlackBox::create());
  }
}

bool BlackBoxes::is_written(const Box& box) { return write_time(box.file) != box.before; }

int BlackBoxes::fd_of(const std::string& process) const noexcept {
  for (const Box& box : boxes_)
    if (box.process == process && box.last_steps) return box.last_steps->fd();
  return -1;
}

void BlackBoxes::take(const std::string& process, const std::string& line) {
  for (Box& box : boxes_)
    if (box.process == process) box.told.emplace_back() << line;
}

std::string BlackBoxes::told() const {
  std::string text;
  for (const Box& box : boxes_)
    if (is_written(box)) text += (text.empty() ? "; black box: " : ", ") + box.file.string();
  return text;
}

std::string BlackBoxes::save_rest() const try {
  std::string text;
  for (const Box& box : boxes_) {
    const std::vector<process::TextLine> lines = box.last_steps ? box.last_steps->lines() : box.told;
    if (lines.empty() || is_written(box)) continue;
    process::write_black_box(box.file, lines, deployment_, box.process, deployment_.clock != config::ClockMode::real);
    text += (text.empty() ? "black box: " : ", ") + box.file.string();
  }
  return text;
} catch (const std::exception& failure) {
  return failure.what();
}

}  // namespace mrroc::cli
