#include "cli/run/side_process.hpp"

#include <poll.h>

#include <utility>

namespace mrroc::cli {

namespace {

constexpr int kFarewell = 1000;  // ms

std::vector<std::string> with_socket(std::vector<std::string> words, const std::filesystem::path& socket) {
  words.insert(words.end(), {"--socket", socket.string()});
  return words;
}

}  // namespace

SideProcess::SideProcess(std::string name, const std::string& program, std::vector<std::string> words,
                         const std::filesystem::path& socket, Show show)
    : name_(std::move(name)), child_(name_, program, with_socket(std::move(words), socket)), show_(std::move(show)) {}

SideProcess::~SideProcess() {
  // the socket has been closed: it ends by itself
  const int handle = child_.output_fd();
  pollfd end{handle, 0, 0};
  if (!child_.ended()) ::poll(&end, 1, kFarewell);
}

void SideProcess::poll() {
  if (ended_) return;
  const bool over = child_.ended();
  for (std::string& line : child_.read_lines()) {
    serves_ = serves_ || line.starts_with(name_ + ": ");
    lines_.push_back(std::move(line));
  }
  ended_ = over;
  // of one that never serves, the last line is why the run fails, which shows it
  if (over && !serves_ && !lines_.empty()) lines_.pop_back();
  if (over || serves_)
    for (const std::string& line : std::exchange(lines_, {})) show_(line);
  if (over && serves_) show_("the process '" + name_ + "' has ended: " + child_.how_it_ended() + "; the run continues");
}

}  // namespace mrroc::cli
