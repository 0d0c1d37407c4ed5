#include "cli/hosts/remote_host.hpp"

#include <spdlog/fmt/fmt.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <sstream>
#include <stdexcept>

#include "clock/wall/monotonic.hpp"

namespace mrroc::cli {

namespace {

namespace fs = std::filesystem;

constexpr std::int64_t kPatienceWithKernel = clock::kSecond / 10;  // from the end of a channel to that of its process

/// The word in quotes, as a POSIX shell reads it back.
std::string in_shell_quotes(const std::string& word) {
  std::string quoted = "'";
  for (const char character : word) quoted += character == '\'' ? "'\\''" : std::string(1, character);
  return quoted + "'";
}

/// The path of the program of this name, found as a shell does.
std::string found_on_path(const std::string& program) {
  if (program.find('/') != std::string::npos) return program;
  const char* const path = std::getenv("PATH");
  std::istringstream folders(path != nullptr ? path : "/usr/bin:/bin");
  for (std::string folder; std::getline(folders, folder, ':');) {
    std::string candidate = fs::path(folder) / program;
    if (access(candidate.c_str(), X_OK) == 0 && fs::is_regular_file(candidate)) return candidate;
  }
  throw std::runtime_error("no program '" + program + "' in the folders of $PATH");
}

/// Starts the command with one end of a new channel; `channel` becomes the other end.
Child start(const std::string& name, std::vector<std::string> words, std::unique_ptr<LineChannel>& channel) {
  const std::string program = found_on_path(words.front());
  words.erase(words.begin());
  int ends[2];
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0)
    throw std::runtime_error(std::string{"no channel: "} + std::strerror(errno));
  channel = std::make_unique<LineChannel>(ends[0], ends[0]);
  try {
    Child child(name, program, words, ends[1]);
    close(ends[1]);
    return child;
  } catch (...) {
    close(ends[1]);
    throw;
  }
}

}  // namespace

std::vector<std::string> agent_command(const config::HostEntry& host) {
  const std::string mrroc = host.mrroc.empty() ? fs::read_symlink("/proc/self/exe").string() : host.mrroc;
  if (host.command.empty()) {
    // never asks; no terminal; gives up soon when the host does not answer
    return {"ssh",
            "-T",
            "-o",
            "BatchMode=yes",
            "-o",
            "ConnectTimeout=10",
            "--",
            host.address,
            in_shell_quotes(mrroc) + " agent"};
  }
  std::vector<std::string> words = host.command;
  words.push_back(mrroc);
  words.emplace_back("agent");
  return words;
}

RemoteHost::RemoteHost(const config::HostEntry& entry, AgentOrder order, in_addr own, in_addr there, HostLimits limits,
                       const HostListener& listener, clock::EmergencyStop& emergency_stop)
    : name_(entry.name),
      there_(there),
      limits_(limits),
      listener_(listener),
      link_(own, order.domain, order.key = new_beat_key(), true, limits.link_timeout, emergency_stop),
      agent_(cli::start(entry.name, agent_command(entry), channel_)) {
  order.beat_port = link_.port();
  for (const std::string& line : to_lines(order)) channel_->write(line);
  channel_->write("go");
}

std::vector<int> RemoteHost::descriptors() const { return {channel_->fd(), agent_.output_fd(), link_.event_fd()}; }

void RemoteHost::poll() {
  const bool over = agent_.ended();  // before the read, which then gets everything that it wrote
  for (const std::string& line : channel_->read()) hear(line);
  for (const std::string& line : agent_.read_lines()) listener_.message("host " + name_ + " | " + line);
  channel_->flush();
  if (!said_ended_ && (over || channel_->closed())) poll_agent();
  if (!stopped_ && gone_since_ == 0) poll_link();  // the silence of an agent that is gone is only a consequence
}

void RemoteHost::hear(const std::string& line) {
  const auto [word, text] = split_word(line);
  const auto [name, rest] = split_word(text);
  if (!greeted_) {
    // a shell there may print something first
    if (line == kAgentGreeting) {
      greeted_ = true;
    } else if (word == split_word(std::string{kAgentGreeting}).first) {
      fail(process::ExitCode::usage, std::string("another version of MRROC++ is installed there: '")
                                         .append(line)
                                         .append("', expected '")
                                         .append(kAgentGreeting)
                                         .append("'"));
    } else {
      listener_.message("host " + name_ + " | " + line);
    }
  } else if (word == "beat") {
    const auto port = whole_number(text);
    if (port && *port > 0 && *port <= 65535) link_.start(there_, static_cast<int>(*port));
  } else if (word == "missing") {
    told_missing_ = true;
    missing_ = text;
  } else if (word == "line") {
    listener_.message(name + " | " + rest);
  } else if (word == "step") {
    step_at_ = clock::monotonic_ns();
    std::optional<recording::RecordedStep> step = step_of(rest);
    if (!step) return fail(process::ExitCode::system, "a step of " + name + " is damaged");
    listener_.step(name, std::move(*step));
  } else if (word == "steps_end") {
    const auto [added, dropped] = split_word(rest);
    listener_.steps_end(name, {static_cast<std::uint64_t>(whole_number(added).value_or(0)),
                               static_cast<std::uint64_t>(whole_number(dropped).value_or(0))});
  } else if (word == "last_step") {
    step_at_ = clock::monotonic_ns();
    // of a run that may have succeeded
    if (std::optional<recording::RecordedStep> step = step_of(rest)) listener_.last_step(name, std::move(*step));
  } else if (word == "lost") {
    const auto [code, how] = split_word(rest);
    listener_.lost(name, static_cast<int>(whole_number(code).value_or(-1)), how);
  } else if (word == "failed") {
    const auto code = whole_number(name).value_or(static_cast<int>(process::ExitCode::system));
    fail(static_cast<process::ExitCode>(code), rest);
  } else if (word == "ended") {
    said_ended_ = true;
  }
}

void RemoteHost::poll_agent() {
  if (told_gone_) return;
  // its channel closes a moment before the kernel reports how it ended
  const std::int64_t now = clock::monotonic_ns();
  if (gone_since_ == 0) gone_since_ = now;
  if (!agent_.ended() && now - gone_since_ < kPatienceWithKernel) return;
  told_gone_ = true;
  std::string reason = greeted_ ? "its agent is gone" : "no agent could be started";
  for (const std::string& line : agent_.read_lines()) listener_.message("host " + name_ + " | " + line);
  if (agent_.ended()) reason += ": " + agent_.how_it_ended();
  if (!agent_.last_line().empty()) reason += ": " + agent_.last_line();
  fail(process::ExitCode::system, reason);
}

void RemoteHost::poll_link() {
  if (link_.lost()) {
    fail(process::ExitCode::system, fmt::format("link lost: nothing received for {} s", limits_.link_timeout));
    return;
  }
  const std::int64_t drift = link_.figures().certain_drift_ns;
  if (static_cast<double>(drift) * 1e-9 > limits_.clock_error) {
    fail(process::ExitCode::system,
         fmt::format("clock lost: its clock has moved by {:.3f} ms since the start, more than clock_error = {} ms",
                     static_cast<double>(drift) * 1e-6, limits_.clock_error * 1e3));
  }
}

void RemoteHost::fail(process::ExitCode code, const std::string& reason) {
  listener_.failed(code, "host " + name_ + ": " + reason);
}

std::vector<std::string> RemoteHost::missing() const {
  if (!greeted_) return {"the agent on host " + name_};
  std::vector<std::string> names;
  std::istringstream words(missing_);
  for (std::string word; words >> word;) names.push_back(word);
  if (!told_missing_) names.push_back("the processes of host " + name_);
  if (!names.empty()) return names;
  const auto offset = link_.offset();
  if (!offset) return {"the clock of host " + name_ + " (nothing received from it yet)"};
  const double error = static_cast<double>(offset->error_ns) * 1e-9;
  if (error <= limits_.clock_error) return {};
  return {fmt::format(
      "the clock of host {} (known to {:.3f} ms, because its answers take {:.3f} ms; expected clock_error = {} ms)",
      name_, error * 1e3, 2 * error * 1e3, limits_.clock_error * 1e3)};
}

std::int64_t RemoteHost::clock_error_ns() const {
  const auto offset = link_.offset();
  return offset ? offset->error_ns : 0;
}

void RemoteHost::start(std::int64_t epoch_ns) {
  channel_->write("start " + std::to_string(epoch_ns + link_.offset().value_or(clock::ClockOffset{}).ns));
  link_.watch();
}

void RemoteHost::stop() {
  if (stopped_) return;
  stopped_ = true;
  channel_->write("stop");
  if (!link_.lost()) return;
  // a host that is cut off never answers and stops on its own: its command need not wait
  channel_->finish();
  agent_.signal(SIGTERM);
}

std::string RemoteHost::summary() const {
  const LinkFigures figures = link_.figures();
  const auto us = [](std::int64_t ns) { return static_cast<double>(ns) * 1e-3; };
  return fmt::format(
      "{:<10} clock known to {:.0f} us, drift {:.0f} us; {} of {} beats received, longest silence {:.1f} ms", name_,
      us(clock_error_ns()), us(figures.drift_ns), figures.heard, figures.sent, us(figures.longest_silence) * 1e-3);
}

}  // namespace mrroc::cli
