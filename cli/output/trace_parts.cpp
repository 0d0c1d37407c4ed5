#include "cli/output/trace_parts.hpp"

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <utility>

#include "cli/output/trace.hpp"

namespace mrroc::cli {

namespace {

/// The name of a part without its number.
std::string stem_of(const TraceOutput& output, const std::string& process) {
  if (output.is_file()) return output.file().path().string() + "." + process;
  return std::filesystem::temp_directory_path() / ("mrroc-" + std::to_string(getpid()) + "." + process);
}

process::ClaimedFile new_part(const std::string& stem) {
  const auto name = [&stem](std::uint64_t number) {
    std::string file = stem;
    if (number > 1) file.append(".").append(std::to_string(number));
    return file.append(".part");
  };
  return process::ClaimedFile::create(name, "the trace");
}

}  // namespace

TraceParts::TraceParts(const TraceOutput& output, const std::vector<PlannedProcess>& processes) {
  try {
    for (const PlannedProcess& process : processes)
      if (process.has_task) parts_.emplace(process.name, new_part(stem_of(output, process.name)));
  } catch (...) {
    remove();
    throw;
  }
}

int TraceParts::fd_of(const std::string& process) const noexcept {
  const auto part = parts_.find(process);
  return part == parts_.end() ? -1 : part->second.fd();
}

void TraceParts::take(const std::string& process, const std::string& line) {
  const int fd = fd_of(process);
  const std::string text = line + "\n";
  for (std::size_t written = 0; fd >= 0 && failure_ == 0 && written < text.size();) {
    const ssize_t size = ::write(fd, text.data() + written, text.size() - written);
    if (size < 0 && errno == EINTR) continue;
    if (size <= 0) failure_ = size < 0 ? errno : EIO;
    written += static_cast<std::size_t>(std::max<ssize_t>(size, 0));
  }
}

void TraceParts::join(TraceOutput& output, config::ClockMode clock, const TraceOutput::Continue& go_on) try {
  if (failure_ != 0)
    throw std::runtime_error("cannot write the trace " + output.file().path().string() + ": " +
                             std::strerror(failure_));
  std::vector<std::filesystem::path> files;
  for (const auto& [process, part] : parts_) files.push_back(part.path());
  merge_traces(files, clock, [&](std::string_view text) { output.write(text, go_on); });
  output.close();
  remove();
} catch (const std::runtime_error& error) {
  std::string names;
  for (const auto& [process, part] : parts_) names += (names.empty() ? "" : ", ") + part.path().string();
  throw std::runtime_error(std::string{error.what()} + "; its parts are kept: " + names);
}

void TraceParts::remove() {
  std::error_code ignored;
  for (const auto& [process, part] : parts_)
    if (part.in_place()) std::filesystem::remove(part.path(), ignored);
}

}  // namespace mrroc::cli
