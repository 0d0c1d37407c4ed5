#pragma once

namespace mrroc::process {

class Process;

/// While it lives, task objects that are built belong to `process`: so a task class needs no constructor of its own
/// (`Irb6 arm{*this};` is all it writes). Main thread.
class BuildScope {
 public:
  explicit BuildScope(Process& process) noexcept;
  ~BuildScope();
  BuildScope(const BuildScope&) = delete;
  BuildScope& operator=(const BuildScope&) = delete;

  /// The process of the innermost scope. Throws std::logic_error outside of any: a task was built by hand.
  static Process& process();

 private:
  Process* outer_;
};

}  // namespace mrroc::process
