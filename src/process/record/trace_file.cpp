#include "process/record/trace_file.hpp"

#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <utility>

#include "command/output_stream.hpp"

namespace mrroc::process {

namespace {

std::string problem(const std::filesystem::path& path, int reason) {
  return std::string{kTraceProblem} + path.string() + ": " + std::strerror(reason);
}

}  // namespace

TraceFile::TraceFile(const std::filesystem::path& path, std::string process, bool lossless)
    : path_(path),
      file_(std::fopen(path.c_str(), "we")),
      process_(std::move(process)),
      lossless_(lossless),
      ring_(kLines) {
  if (file_ == nullptr) throw std::runtime_error(problem(path_, errno));
  thread_ = std::thread([this] { run(); });
}

TraceFile::TraceFile(int fd, std::filesystem::path path, std::string process, bool lossless)
    : path_(std::move(path)),
      file_(command::output_stream(fd)),
      process_(std::move(process)),
      lossless_(lossless),
      ring_(kLines) {
  if (file_ == nullptr) throw std::runtime_error(problem(path_, errno));
  thread_ = std::thread([this] { run(); });
}

TraceFile::~TraceFile() {
  if (file_ != nullptr) close();
}

std::string TraceFile::close() {
  ended_ = true;
  wake();
  thread_.join();
  write("# process=" + process_ + " lines=" + std::to_string(written_.load()) + " dropped=" + std::to_string(dropped_) +
        " cut=" + std::to_string(cut_) + "\n");
  if (failure_ == 0 && std::fflush(file_) != 0) failure_ = errno;
  if (std::fclose(std::exchange(file_, nullptr)) != 0 && failure_ == 0) failure_ = errno;
  return failure_ == 0 ? "" : problem(path_, failure_);
}

TextLine* TraceFile::begin() noexcept {
  const std::uint64_t written = written_.load(std::memory_order_relaxed);
  std::uint64_t read = read_.load(std::memory_order_acquire);
  while (written - read >= kLines) {
    if (!lossless_) {
      ++dropped_;
      return nullptr;
    }
    read_.wait(read);
    read = read_.load(std::memory_order_acquire);
  }
  TextLine& line = ring_[written % kLines];
  line.clear();
  return &line;
}

void TraceFile::commit() noexcept {
  if (ring_[written_.load(std::memory_order_relaxed) % kLines].cut()) ++cut_;
  written_.fetch_add(1, std::memory_order_release);
  wake();
}

void TraceFile::wake() noexcept {
  signals_.fetch_add(1, std::memory_order_release);
  signals_.notify_one();
}

void TraceFile::run() {
  for (;;) {
    const std::uint64_t seen = signals_.load(std::memory_order_acquire);
    if (ended_) break;
    drain();
    signals_.wait(seen);
  }
  drain();
}

void TraceFile::drain() {
  while (read_.load(std::memory_order_relaxed) < written_.load(std::memory_order_acquire)) {
    const TextLine& line = ring_[read_.load(std::memory_order_relaxed) % kLines];
    write(line.view());
    write("\n");
    read_.fetch_add(1, std::memory_order_release);
    read_.notify_one();
  }
  if (failure_ == 0 && std::fflush(file_) != 0) failure_ = errno;
}

void TraceFile::write(std::string_view text) noexcept {
  if (failure_ == 0 && std::fwrite(text.data(), 1, text.size(), file_) != text.size()) failure_ = errno;
}

}  // namespace mrroc::process
