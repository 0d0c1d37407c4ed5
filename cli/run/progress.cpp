#include "cli/run/progress.hpp"

#include <spdlog/fmt/fmt.h>
#include <unistd.h>

#include <utility>

#include "clock/wall/monotonic.hpp"
#include "command/printable.hpp"

namespace mrroc::cli {

namespace {

constexpr std::size_t kLongestPrompt = 76;                        // bytes
constexpr std::int64_t kPatienceWithReader = 2 * clock::kSecond;  // at the end

const char* text_of(links::ProcessState state) {
  switch (state) {
    case links::ProcessState::starting:
      return "starting";
    case links::ProcessState::ready:
      return "ready";
    case links::ProcessState::running:
      return "running";
    case links::ProcessState::ended:
      return "ended";
    case links::ProcessState::failed:
      return "FAILED";
  }
  return "?";
}

std::string activity_of(const links::ProcessStatus& status) {
  if (status.instruction == 0) return "";
  return fmt::format("{} {:<28} step {:>5}", status.instruction, command::printable(status.activity.view()),
                     status.step);
}

}  // namespace

Progress::Progress(std::vector<std::string> processes, double servo_period, bool quiet, int output)
    : out_(output),
      err_(STDERR_FILENO),
      names_(std::move(processes)),
      servo_period_(servo_period),
      quiet_(quiet),
      live_(!quiet && isatty(output) != 0) {}

Progress::~Progress() {
  const std::int64_t deadline = clock::monotonic_ns() + kPatienceWithReader;
  err_.drain(deadline);
  out_.drain(deadline);
}

void Progress::update(const links::ProcessStatus& status) {
  links::ProcessStatus& known = statuses_[std::string{status.process.view()}];
  const links::ProcessStatus before = known;
  known = status;
  if (!quiet_ && !live_) print_change(before, status);
}

void Progress::print_change(const links::ProcessStatus& before, const links::ProcessStatus& now) {
  const bool first = before.process.empty();
  if (first || before.state != now.state)
    out_.write(fmt::format("{:<12} {}\n", now.process.view(), text_of(now.state)));
  // both may have changed since the last status: a process that starts is soon at its first instruction
  if (before.instruction != now.instruction) {
    out_.write(fmt::format("{:<12} {:8.3f} s  {}\n", now.process.view(), static_cast<double>(now.tick) * servo_period_,
                           activity_of(now)));
  }
}

void Progress::message(const std::string& text) {
  listener_(text);
  notice(text);
}

void Progress::notice(const std::string& text) {
  out_.write(erasure() + command::printable_lines(text) + "\n");
  draw();
}

void Progress::error(const std::string& text) {
  listener_(text);
  out_.write(erasure());
  err_.write(command::printable_lines(text) + "\n");
  draw();
}

void Progress::draw() {
  err_.flush();
  out_.flush();
  // an output that has not taken older text gets no new live lines
  if (!live_ || paused_ || !out_.empty()) return;
  std::string lines = erasure();
  for (const std::string& name : names_) {
    const auto found = statuses_.find(name);
    if (found == statuses_.end()) {
      lines += fmt::format("{:<12} -\n", name);
    } else {
      const links::ProcessStatus& status = found->second;
      lines += fmt::format("{:<12} {:<8} {:9.3f} s  {}\n", name, text_of(status.state),
                           static_cast<double>(status.tick) * servo_period_, activity_of(status));
    }
  }
  drawn_lines_ = names_.size();
  prompt_drawn_ = !prompt_.empty();
  out_.write(lines + prompt_);
}

std::string Progress::erasure() {
  std::string line_begin = std::exchange(prompt_drawn_, false) ? "\r\x1b[J" : "";
  if (drawn_lines_ == 0) return line_begin;
  return line_begin + fmt::format("\x1b[{}A\x1b[J", std::exchange(drawn_lines_, 0));
}

void Progress::prompt(const std::string& text) {
  // of a long line the end, which is being typed
  std::size_t begin = text.size() > kLongestPrompt ? text.size() - kLongestPrompt : 0;
  while (begin < text.size() && (static_cast<unsigned char>(text[begin]) & 0xc0) == 0x80) ++begin;
  prompt_ = command::printable(text.substr(begin));
}

void Progress::pause(bool paused) {
  if (paused) out_.write(erasure());
  paused_ = paused;
}

void Progress::finish() {
  if (std::exchange(prompt_drawn_, false)) out_.write("\r\x1b[J");
  drawn_lines_ = 0;
  live_ = false;
}

}  // namespace mrroc::cli
