#pragma once

#include <sys/types.h>

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "mrroc/testing/scratch_folder.hpp"
#include "repetitions.hpp"

namespace mrroc::test {

using task_test::ScratchFolder;

/// A run of the `mrroc` command as a user would start it, from the source folder.
class MrrocRun {
 public:
  /// `place` above 0: started at the same time as others, each on its own CPU where there are enough. A run in lockstep
  /// stays on its first CPU, and two runs might choose the same one. `output`: a file or device for the output, instead
  /// of `out` and `err`.
  explicit MrrocRun(const std::vector<std::string>& arguments, int place = 0, const std::filesystem::path& output = {});
  /// Kills the run when it still exists.
  ~MrrocRun();
  MrrocRun(const MrrocRun&) = delete;
  MrrocRun& operator=(const MrrocRun&) = delete;

  pid_t pid() const noexcept { return pid_; }
  static constexpr int kPatience = kSanitized ? 480 : 120;  ///< s
  static constexpr int kLongPatience = 1200;                ///< s, with a task that takes minutes under a sanitizer
  /// Waits for its end; returns the exit code, or minus the signal that ended it. After `patience` s it is killed and
  /// the test fails.
  int wait(int patience = kPatience);
  /// True when its output contains `text`; false when it has ended before.
  bool wait_for_output(const std::string& text);
  void signal(int number) const;
  /// Whether it has ended.
  bool has_ended();

  /// The process of this run that was started with `--name NAME`; -1 when there is none (yet).
  pid_t child(const std::string& name) const;
  /// All processes that it has started and that still exist.
  std::vector<pid_t> children() const;
  /// The same with their own children, such as those of agents for other hosts.
  std::vector<pid_t> descendants() const;
  /// As `child`, among its descendants.
  pid_t descendant(const std::string& name) const;

  std::string out() const;
  std::string err() const;

 private:
  ScratchFolder folder_;
  pid_t pid_ = -1;
  bool ended_ = false;
  int status_ = 0;
};

/// The parent of a process that runs; -1 when there is none or it has ended and waits to be reaped.
pid_t parent_of(pid_t pid);

/// Waits for the end of processes that are not this one's children; false when one still exists after 10 s.
bool all_end(const std::vector<pid_t>& pids);

/// TOML of a deployment of one irb6, "arm", with loopback drives, whose task has the error `kind`: see
/// tests/system/programs/faulty.cpp. More lines may follow.
std::string faulty_deployment(const std::string& kind, const std::string& clock = "lockstep");

/// Runs to the end. Checks that the exit code is `expected`, shows the output when it is not, and checks that the
/// trace, if one is written, keeps the rules. Returns stdout and stderr.
std::string run_mrroc(const std::vector<std::string>& arguments, int expected, int patience = MrrocRun::kPatience);

/// Runs two at the same time, for two cores; checks each like run_mrroc(). Returns the output of each.
std::array<std::string, 2> run_two(const std::array<std::vector<std::string>, 2>& arguments, int expected,
                                   int patience = MrrocRun::kPatience);

/// Checks that the trace keeps the laws of Move and Wait: `mrroc trace check`.
void expect_laws(const std::filesystem::path& trace);

/// Hash of a trace, by `mrroc trace hash`.
std::string trace_hash(const std::filesystem::path& trace);

/// Busy loops on every CPU during its lifetime.
class Load {
 public:
  explicit Load(int processes);
  ~Load();
  Load(const Load&) = delete;
  Load& operator=(const Load&) = delete;

 private:
  std::vector<pid_t> pids_;
};

}  // namespace mrroc::test
