#include "cli/output/black_boxes.hpp"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "process/record/black_box_file.hpp"
#include "process/record/claimed_file.hpp"

namespace mrroc::cli {

BlackBoxes::BlackBoxes(const std::filesystem::path& folder, const config::Deployment& deployment,
                       const std::string& text, const std::vector<PlannedProcess>& processes)
    : folder_(folder), deployment_(deployment), text_(text) {
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

std::string BlackBoxes::problem() const {
  if (folder_.empty()) return "";
  std::error_code unknown;
  std::filesystem::path nearest = std::filesystem::absolute(folder_);
  while (std::filesystem::symlink_status(nearest, unknown).type() == std::filesystem::file_type::not_found)
    nearest = nearest.parent_path();
  if (std::filesystem::exists(nearest, unknown) && !std::filesystem::is_directory(nearest, unknown))
    return nearest.string() + " is not a folder";
  return access(nearest.c_str(), W_OK | X_OK) == 0 ? "" : nearest.string() + ": " + std::strerror(errno);
}

int BlackBoxes::fd_of(const std::string& process) const noexcept {
  for (const Box& box : boxes_)
    if (box.process == process && box.last_steps) return box.last_steps->fd();
  return -1;
}

void BlackBoxes::take(const std::string& process, recording::RecordedStep step) {
  const auto is_it = [&process](const Box& box) { return box.process == process; };
  const auto box = std::find_if(boxes_.begin(), boxes_.end(), is_it);
  if (box != boxes_.end()) box->reported.push_back(std::move(step));
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
    const std::vector<recording::RecordedStep> steps = box.last_steps ? box.last_steps->steps() : box.reported;
    if (steps.empty() || !written(box).empty()) continue;
    const bool simulated = deployment_.clock != config::ClockMode::real;
    const std::uint64_t number = process::write_black_box(folder_, steps, deployment_, text_, box.process, simulated);
    text += (text.empty() ? "black box: " : ", ") +
            process::black_box_path(folder_, deployment_, box.process, number).string();
  }
  return text;
} catch (const std::exception& failure) {
  return failure.what();
}

std::string BlackBoxes::record(const std::filesystem::path& path) const {
  if (boxes_.empty()) throw std::logic_error("this run keeps no last steps");
  recording::LastSteps steps;
  std::string names, elsewhere;
  std::size_t count = 0;
  for (const Box& box : boxes_) {
    if (!box.last_steps) elsewhere += (elsewhere.empty() ? "" : ", ") + box.process;
    if (!box.last_steps) continue;
    std::vector<recording::RecordedStep> own = box.last_steps->steps();
    if (own.empty()) continue;
    names += (names.empty() ? "" : ", ") + box.process;
    count += own.size();
    steps.emplace(box.process, std::move(own));
  }
  if (count == 0) throw std::logic_error("no task on this machine has made a step");
  const std::filesystem::path file = std::filesystem::absolute(path).lexically_normal();
  write_steps(file, steps);
  return std::to_string(count) + " steps of " + names +
         (elsewhere.empty() ? "" : ", without those on other hosts: " + elsewhere) + "; black box: " + file.string();
}

void BlackBoxes::write_steps(const std::filesystem::path& path, const recording::LastSteps& steps) const {
  process::ClaimedFile file = process::ClaimedFile::create(path, "the black box");
  const bool simulated = deployment_.clock != config::ClockMode::real;
  int problem = recording::write_last_steps(file.fd(), steps, deployment_, simulated, text_);
  if (const int at_close = file.close(); problem == 0) problem = at_close;
  if (problem == 0) return;
  std::error_code ignored;
  std::filesystem::remove(path, ignored);
  throw std::runtime_error("cannot write the black box " + path.string() + ": " + std::strerror(problem));
}

}  // namespace mrroc::cli
