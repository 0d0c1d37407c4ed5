#include "process/signals/end_request.hpp"

#include <unistd.h>

#include <atomic>
#include <csignal>

#include "process/exit_code.hpp"

namespace mrroc::process {

namespace {

// the only objects that a signal handler can reach
std::atomic<clock::Clock*> interruptible{nullptr};
std::atomic<bool> asked{false};
std::atomic<bool> setting_up{true};
std::atomic<pid_t> runner{0};

constexpr unsigned kTimeoutWithoutRunner = 5;  // s

void on_request(int) {
  // before the barrier nothing moves and nothing needs cleaning up: the process may end at once
  if (setting_up.load()) _exit(static_cast<int>(ExitCode::stopped));
  asked = true;
  alarm(kTimeoutWithoutRunner);
  if (clock::Clock* clock = interruptible.load()) clock->interrupt();
}

void on_alarm(int) {
  if (getppid() != runner.load()) _exit(static_cast<int>(ExitCode::stopped));
  alarm(kTimeoutWithoutRunner);
}

}  // namespace

void receive_end_requests() noexcept {
  runner = getppid();
  struct sigaction request {};
  request.sa_handler = on_request;
  sigaction(SIGTERM, &request, nullptr);
  sigaction(SIGINT, &request, nullptr);
  struct sigaction timeout {};
  timeout.sa_handler = on_alarm;
  timeout.sa_flags = SA_RESTART;  // records that are being written are not cut
  sigaction(SIGALRM, &timeout, nullptr);
  // neither a closed pipe to the runner nor a file size limit may end the process in the middle of a motion
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
}

void set_up_ends() noexcept { setting_up = false; }

bool asked_to_end() noexcept { return asked.load(); }

void interrupt_at_request(clock::Clock* clock) noexcept { interruptible = clock; }

}  // namespace mrroc::process
