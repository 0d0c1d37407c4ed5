#include "cli/output/black_boxes.hpp"

#include <stdexcept>
#include <system_error>

#include "process/record/black_box_file.hpp"

namespace mrroc::cli {

BlackBoxes::BlackBoxes(const std::filesystem::path& folder, const config::Deployment& deployment,
                       const std::vector<PlannedProcess>& processes)
    : folder_(folder), deployment_(deployment) {
  if (folder_.empty()) return;
  for (const PlannedProcess& process : processes) {
    if (!process.has_task) continue;
    Box& box = boxes_.emplace_back(Box{process.name, {}, {}});
    if (process.host.empty()) box.last_steps.emplace(process::SharedBlackBox::create());
  }
}

std::filesystem::path BlackBoxes::written(const Box& box) const {
  const std::uint64_t number = box.last_steps ? box.last_steps->file() : 0;
  return number == 0 ? "" : process::black_box_path(folder_, deployment_, box.process, number);
}

int BlackBoxes::fd_of(const std::string& process) const noexcept {
  for (const Box& box : boxes_)
    if (box.process == process && box.last_steps) return box.last_steps->fd();
  return -1;
}

void BlackBoxes::take(const std::string& process, const std::string& line) {
  for (Box& box : boxes_)
    if (box.process == process) box.reported.emplace_back() << line;
}

std::string BlackBoxes::reported() const {
  std::string text;
  for (const Box& box : boxes_)
    if (const auto file = written(box); !file.empty()) text += (text.empty() ? "; black box: " : ", ") + file.string();
  return text;
}

std::string BlackBoxes::save_rest() const try {
  std::string text;
  for (const Box& box : boxes_) {
    const std::vector<process::TextLine> lines = box.last_steps ? box.last_steps->lines() : box.reported;
    if (lines.empty() || !written(box).empty()) continue;
    const bool simulated = deployment_.clock != config::ClockMode::real;
    const std::uint64_t number = process::write_black_box(folder_, lines, deployment_, box.process, simulated);
    text += (text.empty() ? "black box: " : ", ") +
            process::black_box_path(folder_, deployment_, box.process, number).string();
  }
  return text;
} catch (const std::exception& failure) {
  return failure.what();
}

}  // namespace mrroc::cli
