#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#include <chrono>
#include <string>
#include <thread>

#include "system/mrroc_run.hpp"

namespace mrroc::test::output_test {
namespace {

constexpr int kSystem = 4;
constexpr int kStopped = 5;

/// The processes of a run that has started that of this name.
std::vector<pid_t> processes_with(MrrocRun& run, const std::string& name) {
  while (run.child(name) < 0 && !run.has_ended()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  return run.children();
}

/// A full named pipe without a reader.
class FullPipe {
 public:
  explicit FullPipe(const std::filesystem::path& path) {
    EXPECT_EQ(mkfifo(path.c_str(), 0600), 0);
    reader_ = open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
    const int writer = open(path.c_str(), O_WRONLY | O_NONBLOCK | O_CLOEXEC);
    EXPECT_GE(writer, 0);
    const std::string page(4096, '.');
    while (write(writer, page.data(), page.size()) > 0) {
    }
    close(writer);
  }
  ~FullPipe() { leave(); }
  FullPipe(const FullPipe&) = delete;
  FullPipe& operator=(const FullPipe&) = delete;
  /// From now on no process can read it.
  void leave() {
    if (reader_ >= 0) close(reader_);
    reader_ = -1;
  }

 private:
  int reader_ = -1;
};

TEST(RunnersOutput, RunSucceedsOnAFullDisk) {
  MrrocRun run({"run", "tasks/press/press.toml", "--clock", "lockstep"}, 0, "/dev/full");
  const std::vector<pid_t> pids = processes_with(run, "sim");
  EXPECT_EQ(run.wait(), 0);
  EXPECT_TRUE(all_end(pids));
}

TEST(RunnersOutput, FailureEndsInOrderOnAFullDisk) {
  MrrocRun run({"run", "tasks/press/press.toml", "--clock", "lockstep", "--inject", "kill mp at tick 500"}, 0,
               "/dev/full");
  const std::vector<pid_t> pids = processes_with(run, "sim");
  EXPECT_EQ(run.wait(), kSystem);
  EXPECT_TRUE(all_end(pids));
}

TEST(RunnersOutput, OperatorsInputIsReadWithoutAReaderOfTheOutput) {
  const ScratchFolder folder;
  const FullPipe pipe(folder.path() / "pipe");
  MrrocRun run({"run", folder.write("hold.toml", faulty_deployment("hold", "real")).string()}, 0,
               folder.path() / "pipe");
  const std::vector<pid_t> pids = processes_with(run, "arm");
  run.signal(SIGINT);
  std::this_thread::sleep_for(std::chrono::milliseconds(100));
  run.signal(SIGINT);
  EXPECT_EQ(run.wait(), kStopped);
  EXPECT_TRUE(all_end(pids));
}

TEST(RunnersOutput, RunContinuesWhenItsReaderLeaves) {
  const ScratchFolder folder;
  FullPipe pipe(folder.path() / "pipe");
  MrrocRun run({"run", "tasks/press/press.toml", "--clock", "lockstep"}, 0, folder.path() / "pipe");
  const std::vector<pid_t> pids = processes_with(run, "arm");
  pipe.leave();
  EXPECT_EQ(run.wait(), 0);
  EXPECT_TRUE(all_end(pids));
}

}  // namespace
}  // namespace mrroc::test::output_test
