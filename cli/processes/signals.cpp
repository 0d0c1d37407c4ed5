#include "cli/processes/signals.hpp"

#include <signal.h>
#include <sys/signalfd.h>
#include <unistd.h>

namespace mrroc::cli {

namespace {

int open_signals(std::initializer_list<int> others) {
  sigset_t set;
  sigemptyset(&set);
  for (const int number : {SIGINT, SIGTERM, SIGHUP, SIGCHLD}) sigaddset(&set, number);
  for (const int number : others) sigaddset(&set, number);
  sigprocmask(SIG_BLOCK, &set, nullptr);
  signal(SIGCHLD, SIG_DFL);  // the parent process may ignore it, and then no death would be reported
  signal(SIGPIPE, SIG_IGN);
  signal(SIGXFSZ, SIG_IGN);
  return signalfd(-1, &set, SFD_NONBLOCK | SFD_CLOEXEC);
}

}  // namespace

Signals::Signals(std::initializer_list<int> others) : descriptor_(open_signals(others)) {}

Signals::~Signals() {
  if (descriptor_ >= 0) close(descriptor_);
}

int Signals::take() noexcept {
  signalfd_siginfo info;
  return read(descriptor_, &info, sizeof info) == static_cast<ssize_t>(sizeof info) ? static_cast<int>(info.ssi_signo)
                                                                                    : 0;
}

}  // namespace mrroc::cli
