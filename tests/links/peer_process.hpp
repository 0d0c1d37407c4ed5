#pragma once

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

extern char** environ;

namespace mrroc::links {

/// The program links_peer (peer.cpp) as a child; killed with this object.
class PeerProcess {
 public:
  /// Its default lease (s) outlasts any stall of a busy machine.
  PeerProcess(const std::string& role, int domain, const std::string& prefix, double lease = 20,
              const std::string& more = {}) {
    std::vector<std::string> arguments{
        MRROC_BINARY_DIR "/tests/links_peer", role, std::to_string(domain), prefix, std::to_string(lease), more};
    std::vector<char*> argv;
    for (std::string& argument : arguments) argv.push_back(argument.data());
    argv.push_back(nullptr);
    if (::posix_spawn(&pid_, argv[0], nullptr, nullptr, argv.data(), environ) != 0) {
      throw std::runtime_error("links_peer does not start");
    }
  }
  PeerProcess(PeerProcess&& other) noexcept : pid_(std::exchange(other.pid_, 0)) {}
  PeerProcess& operator=(PeerProcess&&) = delete;
  ~PeerProcess() { kill(); }

  pid_t pid() const noexcept { return pid_; }
  /// Sends SIGKILL; returns when the process has ended.
  void kill() {
    if (pid_ <= 0) return;
    ::kill(pid_, SIGKILL);
    ::waitpid(std::exchange(pid_, 0), nullptr, 0);
  }
  /// Sends SIGSTOP; returns when the process is stopped.
  void stop() {
    ::kill(pid_, SIGSTOP);
    ::waitpid(pid_, nullptr, WUNTRACED);
  }
  void go_on() { ::kill(pid_, SIGCONT); }

 private:
  pid_t pid_ = 0;
};

}  // namespace mrroc::links
