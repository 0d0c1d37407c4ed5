#pragma once

#include <initializer_list>

namespace mrroc::cli {

/// The signals that a process with children receives instead of dying of them: those that request its end (SIGINT,
/// SIGTERM, SIGHUP), SIGCHLD and `others`; from then on they are blocked. SIGPIPE is ignored, because a write reports a
/// missing reader anyway; so is SIGXFSZ, because a file size limit is an error of the write. Main thread, before it
/// starts a thread or a process.
class Signals {
 public:
  explicit Signals(std::initializer_list<int> others = {});
  ~Signals();
  Signals(const Signals&) = delete;
  Signals& operator=(const Signals&) = delete;

  /// Readable when `take` has one.
  int descriptor() const noexcept { return descriptor_; }
  /// The number of the next signal; 0 when no other has come. Never waits.
  int take() noexcept;

 private:
  int descriptor_;  // signalfd
};

}  // namespace mrroc::cli
