#include "process/record/black_box_file.hpp"

#include <algorithm>
#include <cstring>
#include <stdexcept>
#include <system_error>

#include "process/record/claimed_file.hpp"
#include "process/record/step_encoder.hpp"
#include "recording/last_steps.hpp"

namespace mrroc::process {

std::filesystem::path black_box_path(const std::filesystem::path& folder, const config::Deployment& deployment,
                                     const std::string& process, std::uint64_t number) {
  std::string name = deployment.name + "-" + process;
  if (number > 1) name += "-" + std::to_string(number);
  return folder / (name + ".mcap");
}

std::vector<recording::RecordedStep> encoded(const BlackBox& box, const config::Deployment& deployment,
                                             const std::string& process) {
  std::vector<recording::RecordedStep> steps;
  EncodedStep step;
  Tick tick = 0;  // a step of a `Wait` without robots may have an older one
  for (std::size_t i = 0; i < box.size(); ++i) {
    encode_step(step, deployment, process, box.at(i));
    tick = std::max(tick, box.at(i).tick);
    steps.push_back({tick, {step.view().begin(), step.view().end()}});
  }
  return steps;
}

std::uint64_t write_black_box(const std::filesystem::path& folder, const std::vector<recording::RecordedStep>& steps,
                              const config::Deployment& deployment, const std::string& text, const std::string& process,
                              bool simulated) {
  std::error_code ignored;  // opening the file reports the problem of its folder
  std::filesystem::create_directories(folder, ignored);
  const auto name = [&](std::uint64_t number) { return black_box_path(folder, deployment, process, number); };
  ClaimedFile file = ClaimedFile::create(name, "the black box");
  int problem = recording::write_last_steps(file.fd(), {{process, steps}}, deployment, simulated, text);
  if (const int at_close = file.close(); problem == 0) problem = at_close;
  if (problem == 0) return file.number();
  std::filesystem::remove(file.path(), ignored);
  throw std::runtime_error("cannot write the black box " + file.path().string() + ": " + std::strerror(problem));
}

}  // namespace mrroc::process
