#include "process/black_box_file.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <stdexcept>
#include <system_error>

#include "process/step_reporter.hpp"
#include "process/trace_header.hpp"

namespace mrroc::process {

namespace {

/// A simulated clock may be another one than the deployment's: for the rules of a trace they are alike.
const char* clock_of(const config::Deployment& deployment, bool simulated) noexcept {
  if (!simulated) return "real";
  return deployment.clock == config::ClockMode::paced ? "paced" : "lockstep";
}

}  // namespace

std::filesystem::path black_box_path(const std::filesystem::path& folder, const config::Deployment& deployment,
                                     const std::string& process) {
  return folder / (deployment.name + "-" + process + ".trace");
}

void write_black_box(const std::filesystem::path& file, const BlackBox& box, const config::Deployment& deployment,
                     const std::string& process, bool simulated) {
  std::vector<TextLine> lines(box.size());
  for (std::size_t i = 0; i < box.size(); ++i) format_step(lines[i], deployment, process, box.at(i));
  write_black_box(file, lines, deployment, process, simulated);
}

void write_black_box(const std::filesystem::path& file, const std::vector<TextLine>& lines,
                     const config::Deployment& deployment, const std::string& process, bool simulated) {
  std::error_code ignored;  // the file says what is wrong with its folder
  if (file.has_parent_path()) std::filesystem::create_directories(file.parent_path(), ignored);
  std::ofstream out(file, std::ios::binary);
  out << kTraceHeader << clock_of(deployment, simulated) << kBlackBoxMark << '\n';
  for (const TextLine& line : lines) out << line.view() << '\n';
  const auto cut = std::count_if(lines.begin(), lines.end(), [](const TextLine& line) { return line.cut(); });
  out << "# process=" << process << " lines=" << lines.size() << " dropped=0 cut=" << cut << '\n';
  if (!out.flush())
    throw std::runtime_error("cannot write the black box " + file.string() + ": " + std::strerror(errno));
}

}  // namespace mrroc::process
