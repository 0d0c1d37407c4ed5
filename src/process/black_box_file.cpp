#include "process/black_box_file.hpp"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <memory>
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
  std::error_code ignored;  // the file says what is wrong with its folder
  if (file.has_parent_path()) std::filesystem::create_directories(file.parent_path(), ignored);
  std::ofstream out(file, std::ios::binary);
  out << kTraceHeader << clock_of(deployment, simulated) << kBlackBoxMark << '\n';
  const auto line = std::make_unique<TextLine>();
  std::uint64_t cut = 0;
  for (std::size_t i = 0; i < box.size(); ++i) {
    line->clear();
    format_step(*line, deployment, process, box.at(i));
    cut += line->cut() ? 1 : 0;
    out << line->view() << '\n';
  }
  out << "# process=" << process << " lines=" << box.size() << " dropped=0 cut=" << cut << '\n';
  if (!out.flush())
    throw std::runtime_error("cannot write the black box " + file.string() + ": " + std::strerror(errno));
}

}  // namespace mrroc::process
