#pragma once

namespace mrroc::process {

class Process;

/// Task objects that are built during its lifetime belong to `process`, so a task class needs no constructor (`Irb6
/// arm{*this};` is sufficient). Main thread.
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
