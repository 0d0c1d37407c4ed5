#include "cli/processes/child.hpp"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string_view>

namespace mrroc::cli {

namespace {

constexpr std::size_t kLongestLine = 65536;  // longer lines come in pieces, or they would fill the memory
constexpr int kPatienceWithKilled = 3000;    // ms; a debugger can keep a killed process

[[noreturn]] void execute(const std::string& program, char** words, int output, int channel,
                          const std::vector<int>& handed, pid_t parent) {
  // between fork and exec: async-signal-safe calls only
  prctl(PR_SET_PDEATHSIG, SIGTERM);
  if (getppid() != parent) _exit(127);
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
  signal(SIGPIPE, SIG_DFL);  // the runner ignores it, and a child would inherit that
  signal(SIGXFSZ, SIG_DFL);
  setpgid(0, 0);  // the runner forwards Ctrl-C
  dup2(channel >= 0 ? channel : output, STDOUT_FILENO);
  dup2(output, STDERR_FILENO);
  const int input = channel >= 0 ? channel : ::open("/dev/null", O_RDONLY);
  if (input >= 0) dup2(input, STDIN_FILENO);
  for (const int fd : handed) fcntl(fd, F_SETFD, 0);
  execv(program.c_str(), words);
  constexpr char kReason[] = "cannot be executed\n";
  if (write(STDERR_FILENO, kReason, sizeof kReason - 1) < 0) _exit(126);
  _exit(127);
}

/// A `stat` file of proc(5) behind the name; empty: the thread no longer exists.
std::string stat_of(const std::filesystem::path& thread) {
  std::ifstream file(thread / "stat");
  std::string stat;
  std::getline(file, stat);
  const std::size_t name = stat.rfind(')');
  return name == std::string::npos || name + 2 >= stat.size() ? "" : stat.substr(name + 2);
}

/// The state letter; 0: the thread no longer exists.
char state_of(const std::filesystem::path& thread) {
  const std::string stat = stat_of(thread);
  return stat.empty() ? '\0' : stat[0];
}

/// Whether the kernel takes the thread apart, or has done so.
bool is_exiting(const std::filesystem::path& thread) {
  constexpr unsigned kExiting = 4;  // PF_EXITING of the kernel
  std::istringstream stat(stat_of(thread));
  std::string state;
  long parent = 0, group = 0, session = 0, terminal = 0, terminal_group = 0;
  unsigned flags = 0;
  stat >> state >> parent >> group >> session >> terminal >> terminal_group >> flags;
  return stat && (flags & kExiting) != 0;
}

constexpr unsigned long long kKillBit = 1ULL << (SIGKILL - 1);  // of the masks in /proc/PID/status

}  // namespace

Child::Child(std::string name, const std::string& program, const std::vector<std::string>& arguments, int channel,
             const std::vector<int>& handed)
    : name_(std::move(name)) {
  std::vector<char*> words;
  words.push_back(const_cast<char*>(program.c_str()));
  for (const std::string& argument : arguments) words.push_back(const_cast<char*>(argument.c_str()));
  words.push_back(nullptr);
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) throw std::runtime_error(std::string{"pipe: "} + std::strerror(errno));
  fcntl(ends[0], F_SETFL, O_NONBLOCK);
  const pid_t parent = getpid();
  pid_ = fork();
  if (pid_ == 0) execute(program, words.data(), ends[1], channel, handed, parent);
  close(ends[1]);
  output_ = ends[0];
  handle_ = pid_ < 0 ? -1 : static_cast<int>(syscall(SYS_pidfd_open, pid_, 0));  // closes on exec
  if (pid_ < 0) {
    close(output_);
    throw std::runtime_error("cannot start " + name_ + ": " + std::strerror(errno));
  }
}

Child::Child(Child&& other) noexcept
    : name_(std::move(other.name_)),
      pid_(other.pid_),
      handle_(other.handle_),
      output_(other.output_),
      ended_(other.ended_),
      stopped_(other.stopped_),
      status_(other.status_),
      unfinished_(std::move(other.unfinished_)),
      last_line_(std::move(other.last_line_)) {
  other.pid_ = -1;
  other.handle_ = -1;
  other.output_ = -1;
}

Child::~Child() {
  if (pid_ > 0 && !ended()) {
    ::kill(pid_, SIGKILL);
    pollfd end{handle_, POLLIN, 0};
    ::poll(&end, 1, kPatienceWithKilled);
    waitpid(pid_, &status_, WNOHANG);
  }
  if (output_ >= 0) close(output_);
  if (handle_ >= 0) close(handle_);
}

void Child::poll() noexcept {
  int status = 0;
  while (!ended_ && waitpid(pid_, &status, WNOHANG | WUNTRACED | WCONTINUED) == pid_) {
    stopped_ = WIFSTOPPED(status);
    ended_ = WIFEXITED(status) || WIFSIGNALED(status);
    status_ = status;
  }
}

bool Child::ended() noexcept {
  poll();
  return ended_;
}

bool Child::lost() noexcept {
  poll();
  return ended_ || stopped_;
}

bool Child::lives() const noexcept {
  // the pidfd is readable when the last thread has ended; the first one is a zombie while others still close files
  pollfd end{handle_, POLLIN, 0};
  return ::poll(&end, 1, 0) == 0;
}

bool Child::is_at_work() const {
  if (!lives()) return false;
  std::error_code gone;
  for (const auto& thread : std::filesystem::directory_iterator("/proc/" + std::to_string(pid_) + "/task", gone))
    if (std::string_view{"Tt"}.find(state_of(thread.path())) == std::string_view::npos) return true;
  return false;
}

bool Child::is_dying() const {
  const std::filesystem::path process = "/proc/" + std::to_string(pid_);
  std::ifstream status(process / "status");
  for (std::string line; std::getline(status, line);) {
    const std::size_t tab = line.find('\t');
    const std::string value = tab == std::string::npos ? "" : line.substr(tab + 1);
    if (line.starts_with("CoreDumping:") && value == "1") return true;
    const bool signals = line.starts_with("SigPnd:") || line.starts_with("ShdPnd:");
    if (signals && (std::strtoull(value.c_str(), nullptr, 16) & kKillBit) != 0) return true;
  }
  return is_exiting(process);  // after the signal, which it may have taken meanwhile
}

std::string Child::how_it_ended() const {
  if (WIFSTOPPED(status_)) {
    const int number = WSTOPSIG(status_);
    return "stopped by signal " + std::to_string(number) + " (" + strsignal(number) + ")";
  }
  if (WIFSIGNALED(status_)) {
    const int number = WTERMSIG(status_);
    return "signal " + std::to_string(number) + " (" + strsignal(number) + ")";
  }
  return "exit code " + std::to_string(WEXITSTATUS(status_));
}

std::string Child::how_it_was_lost() const {
  std::string how = (ended_ ? "died: " : "is ") + how_it_ended();
  if (exit_code() && !last_line_.empty()) how += ": " + last_line_;
  return how;
}

std::optional<int> Child::exit_code() const noexcept {
  if (!ended_ || !WIFEXITED(status_)) return std::nullopt;
  return WEXITSTATUS(status_);
}

void Child::signal(int number) const noexcept {
  if (handle_ >= 0) syscall(SYS_pidfd_send_signal, handle_, number, nullptr, 0);
}

std::vector<std::string> Child::read_lines() {
  // no more than a pipe holds: a process that never stops printing must not block the runner
  char buffer[65536];
  if (const ssize_t size = read(output_, buffer, sizeof buffer); size > 0)
    unfinished_.append(buffer, static_cast<std::size_t>(size));
  std::vector<std::string> lines;
  std::size_t end = 0;
  while ((end = unfinished_.find('\n')) != std::string::npos) {
    lines.push_back(unfinished_.substr(0, end));
    unfinished_.erase(0, end + 1);
  }
  if (!unfinished_.empty() && (ended_ || unfinished_.size() > kLongestLine)) {
    lines.push_back(unfinished_);
    unfinished_.clear();
  }
  if (!lines.empty()) last_line_ = lines.back();
  return lines;
}

std::string Child::wait_for_output() {
  constexpr int kTurn = 20;  // ms
  std::string text;
  for (bool all = false; !all;) {
    pollfd output{output_, POLLIN, 0};
    ::poll(&output, 1, kTurn);
    all = ended();  // before the last read, which then gets everything that it wrote
    for (const std::string& line : read_lines()) text += line + "\n";
  }
  return text;
}

}  // namespace mrroc::cli
