#include "process/signals/stop_signals.hpp"

#include <signal.h>
#include <sys/signalfd.h>

#include <initializer_list>

namespace mrroc::process {

int stop_signals() noexcept {
  sigset_t signals;
  sigemptyset(&signals);
  for (const int number : {SIGTERM, SIGINT, SIGHUP}) sigaddset(&signals, number);
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);
  return signalfd(-1, &signals, SFD_CLOEXEC);
}

}  // namespace mrroc::process
