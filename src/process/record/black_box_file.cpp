#include "process/record/black_box_file.hpp"

#include <algorithm>
#include <cstring>
#include <stdexcept>
#include <system_error>

#include "config/clock_names.hpp"
#include "process/record/claimed_file.hpp"
#include "process/record/step_reporter.hpp"
#include "process/record/trace_header.hpp"

namespace mrroc::process {

namespace {

/// A simulated clock may differ from the deployment's: for the rules of a trace they are equivalent.
const char* clock_of(const config::Deployment& deployment, bool simulated) noexcept {
  const bool differs = simulated && deployment.clock == config::ClockMode::real;
  return config::name_of(!simulated ? config::ClockMode::real
                         : differs  ? config::ClockMode::lockstep
                                    : deployment.clock);
}

}  // namespace

std::filesystem::path black_box_path(const std::filesystem::path& folder, const config::Deployment& deployment,
                                     const std::string& process, std::uint64_t number) {
  std::string name = deployment.name + "-" + process;
  if (number > 1) name += "-" + std::to_string(number);
  return folder / (name + ".trace");
}

std::uint64_t write_black_box(const std::filesystem::path& folder, const BlackBox& box,
                              const config::Deployment& deployment, const std::string& process, bool simulated) {
  std::vector<TextLine> lines(box.size());
  for (std::size_t i = 0; i < box.size(); ++i) format_step(lines[i], deployment, process, box.at(i));
  return write_black_box(folder, lines, deployment, process, simulated);
}

std::uint64_t write_black_box(const std::filesystem::path& folder, const std::vector<TextLine>& lines,
                              const config::Deployment& deployment, const std::string& process, bool simulated) {
  std::error_code ignored;  // opening the file reports the problem of its folder
  std::filesystem::create_directories(folder, ignored);
  const auto name = [&](std::uint64_t number) { return black_box_path(folder, deployment, process, number); };
  ClaimedFile file = ClaimedFile::create(name, "the black box");
  std::string text = black_box_header(deployment, simulated);
  for (const TextLine& line : lines) text.append(line.view()).append("\n");
  text += black_box_remark(process, lines);
  int problem = file.write(text);
  if (const int at_close = file.close(); problem == 0) problem = at_close;
  if (problem == 0) return file.number();
  std::filesystem::remove(file.path(), ignored);
  throw std::runtime_error("cannot write the black box " + file.path().string() + ": " + std::strerror(problem));
}

std::string black_box_header(const config::Deployment& deployment, bool simulated) {
  return std::string{kTraceHeader} + clock_of(deployment, simulated) + std::string{kBlackBoxMark} + "\n";
}

std::string black_box_remark(const std::string& process, const std::vector<TextLine>& lines) {
  const auto cut = std::count_if(lines.begin(), lines.end(), [](const TextLine& line) { return line.cut(); });
  return "# process=" + process + " lines=" + std::to_string(lines.size()) + " dropped=0 cut=" + std::to_string(cut) +
         "\n";
}

}  // namespace mrroc::process
