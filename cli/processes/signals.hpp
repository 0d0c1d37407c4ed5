#pragma once

#include <initializer_list>

namespace mrroc::cli {

/// The signals that whoever starts processes hears instead of dying of them: those that ask it to end (SIGINT, SIGTERM,
/// SIGHUP), SIGCHLD and `others`; from then on they are blocked. SIGPIPE is ignored: who does not read what it says is
/// found gone otherwise; so is SIGXFSZ: a file size limit is an error of the write. Main thread, before it starts a
/// thread or a process.
class Signals {
 public:
  explicit Signals(std::initializer_list<int> others = {});
  ~Signals();
  Signals(const Signals&) = delete;
  Signals& operator=(const Signals&) = delete;

  /// Readable when `take` has one.
  int descriptor() const noexcept { return descriptor_; }
  /// The number of the next; 0: no other has come. Never waits.
  int take() noexcept;

 private:
  int descriptor_;  // signalfd
};

}  // namespace mrroc::cli
