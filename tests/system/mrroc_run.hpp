#pragma once

#include <sys/types.h>

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "mrroc/testing/scratch_folder.hpp"

namespace mrroc::test {

using task_test::ScratchFolder;

/// A run of the `mrroc` command as a user would start it, from the source folder.
class MrrocRun {
 public:
  /// `place` above 0: beside others, each on a CPU of its own as far as there are so many. A run in lockstep keeps to
  /// the CPU that it finds itself on, and two might to one. `output`: a file or device that takes what it says instead
  /// of `out` and `err`.
  explicit MrrocRun(const std::vector<std::string>& arguments, int place = 0, const std::filesystem::path& output = {});
  /// Kills it when it is still there.
  ~MrrocRun();
  MrrocRun(const MrrocRun&) = delete;
  MrrocRun& operator=(const MrrocRun&) = delete;

  pid_t pid() const noexcept { return pid_; }
  static constexpr int kPatience = 120;       ///< s
  static constexpr int kLongPatience = 1200;  ///< s, with a task that takes minutes under a sanitizer
  /// Waits for its end; returns the exit code, or minus the signal that ended it. After `patience` s it is killed and
  /// the test fails.
  int wait(int patience = kPatience);
  /// True when its output has come to contain `text`; false when it has ended before.
  bool wait_for_output(const std::string& text);
  void signal(int number) const;
  /// Whether it has ended.
  bool has_ended();

  /// The process of this run that was started with `--name NAME`; -1 when there is none (yet).
  pid_t child(const std::string& name) const;
  /// All processes that it has started and that are still there.
  std::vector<pid_t> children() const;
  /// The same with those that they have started, as agents for other hosts do.
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

/// Waits for the end of processes that are not this one's children; false when one is still there after 10 s.
bool all_end(const std::vector<pid_t>& pids);

/// TOML of a deployment of one irb6, "arm", with loopback drives, whose task does what `kind` says: see
/// tests/system/programs/faulty.cpp. More lines may follow.
std::string faulty_deployment(const std::string& kind, const std::string& clock = "lockstep");

/// Runs to the end; checks that the exit code is `expected` and shows the output when it is not, and that the trace, if
/// one is written, keeps the laws. Returns stdout and stderr.
std::string run_mrroc(const std::vector<std::string>& arguments, int expected, int patience = MrrocRun::kPatience);

/// Runs two at the same time, for there are two cores; checks each as run_mrroc() does. Returns what each has printed.
std::array<std::string, 2> run_two(const std::array<std::vector<std::string>, 2>& arguments, int expected,
                                   int patience = MrrocRun::kPatience);

/// The trace keeps the laws of Move and Wait: `mrroc trace check`.
void expect_laws(const std::filesystem::path& trace);

/// Hash of a trace, by `mrroc trace hash`.
std::string trace_hash(const std::filesystem::path& trace);

/// Busy loops on every CPU for as long as it lives.
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
