#include "process/trace_file.hpp"

#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <utility>

namespace mrroc::process {

TraceFile::TraceFile(const std::filesystem::path& path, std::string process, bool lossless)
    : file_(std::fopen(path.c_str(), "we")), process_(std::move(process)), lossless_(lossless), ring_(kLines) {
  if (file_ == nullptr)
    throw std::runtime_error("cannot write the trace " + path.string() + ": " + std::strerror(errno));
  thread_ = std::thread([this] { run(); });
}

TraceFile::~TraceFile() {
  ended_ = true;
  wake();
  thread_.join();
  const auto number = [](std::uint64_t value) { return static_cast<unsigned long long>(value); };
  std::fprintf(file_, "# process=%s lines=%llu dropped=%llu cut=%llu\n", process_.c_str(), number(written_),
               number(dropped_), number(cut_));
  const bool failed = std::ferror(file_) != 0;
  if (std::fclose(file_) != 0 || failed) std::fprintf(stderr, "the trace is not complete: %s\n", std::strerror(errno));
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
    std::fwrite(line.view().data(), 1, line.view().size(), file_);
    std::fputc('\n', file_);
    read_.fetch_add(1, std::memory_order_release);
    read_.notify_one();
  }
  std::fflush(file_);
}

}  // namespace mrroc::process
