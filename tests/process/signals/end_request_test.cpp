#include "process/signals/end_request.hpp"

#include <gtest/gtest.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <functional>
#include <memory>

#include "clock/host.hpp"
#include "clock/participant.hpp"
#include "process/exit_code.hpp"

namespace mrroc::process::end_request_test {
namespace {

constexpr int kStopped = static_cast<int>(ExitCode::stopped);

using Reply = std::function<bool()>;

/// The end of the set-up; the process replies whether it was asked to end.
Reply ready() {
  set_up_ends();
  return asked_to_end;
}

template <class Value>
void say(int fd, const Value& value) {
  if (write(fd, &value, sizeof value) != sizeof value) _exit(1);
}

/// A process that receives requests to end and ignores them, like a task that never waits, and that answers questions.
/// Its parent is the test, or a runner that has died.
class EndRequest : public testing::Test {
 protected:
  static void SetUpTestSuite() { prctl(PR_SET_CHILD_SUBREAPER, 1); }  // the end of orphans can be awaited

  void SetUp() override {
    ASSERT_EQ(pipe(questions_), 0);
    ASSERT_EQ(pipe(answers_), 0);
  }

  void TearDown() override {
    if (pid_ > 0) {
      kill(pid_, SIGKILL);
      exit_code();
    }
    for (const int fd : {questions_[0], questions_[1], answers_[0], answers_[1]}) close(fd);
  }

  void start(const std::function<Reply()>& begin = ready) {
    if (fork() == 0) serve(begin);
    pid_ = answer<pid_t>();
  }

  /// As start(); the process that has started it has ended.
  void start_orphan() {
    const pid_t runner = fork();
    if (runner == 0) {
      prctl(PR_SET_PDEATHSIG, SIGKILL);
      if (fork() == 0) serve(ready);
      for (;;) pause();
    }
    pid_ = answer<pid_t>();
    kill(runner, SIGKILL);
    waitpid(runner, nullptr, 0);
  }

  template <class Value>
  Value answer() {
    Value value{};
    EXPECT_EQ(read(answers_[0], &value, sizeof value), static_cast<ssize_t>(sizeof value));
    return value;
  }

  bool reply() {
    say(questions_[1], '?');
    return answer<bool>();
  }

  /// Waits for its end.
  int exit_code() {
    int status = -1;
    waitpid(pid_, &status, 0);
    pid_ = -1;
    return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
  }

  pid_t pid_ = -1;

 private:
  [[noreturn]] void serve(const std::function<Reply()>& begin) {
    receive_end_requests();
    const Reply reply = begin();
    say(answers_[1], getpid());
    close(questions_[1]);  // it ends with the test
    for (char question = 0;;) {
      pollfd next{questions_[0], POLLIN, 0};
      if (poll(&next, 1, -1) < 0) continue;  // the thread sanitizer delays handlers in read(), not in poll()
      const ssize_t count = read(questions_[0], &question, 1);
      if (count == 0) _exit(0);
      if (count == 1) say(answers_[1], reply());
    }
  }

  int questions_[2] = {-1, -1}, answers_[2] = {-1, -1};
};

TEST_F(EndRequest, EndsAProcessThatIsBeingSetUp) {
  start([] { return asked_to_end; });
  kill(pid_, SIGTERM);
  EXPECT_EQ(exit_code(), kStopped);
}

TEST_F(EndRequest, LeavesTheEndToTheProcessAndItsRunner) {
  start();
  EXPECT_FALSE(reply());
  for (const int request : {SIGTERM, SIGINT}) {
    kill(pid_, request);
    EXPECT_TRUE(reply());
    for (int timeouts = 0; timeouts < 3; ++timeouts) {
      kill(pid_, SIGALRM);
      EXPECT_TRUE(reply()) << timeouts;
    }
  }
}

TEST_F(EndRequest, InterruptsTheClock) {
  start([] {
    clock::HostOptions options;
    options.mode = clock::Mode::real;
    options.participants = {"arm"};
    const auto host = std::make_shared<clock::ClockHost>(options);
    const std::shared_ptr<clock::Clock> clock = clock::attach_clock(host->fd(), "arm", clock::Part::task);
    interrupt_at_request(clock.get());
    set_up_ends();
    return Reply([host, clock] { return !clock->start(); });
  });
  kill(pid_, SIGTERM);
  EXPECT_TRUE(reply());
}

TEST_F(EndRequest, EndsAProcessThatHasLostItsRunner) {
  start_orphan();
  kill(pid_, SIGTERM);
  EXPECT_TRUE(reply());
  kill(pid_, SIGALRM);
  EXPECT_EQ(exit_code(), kStopped);
}

TEST_F(EndRequest, HasATimeoutWithoutARunner) {
  start_orphan();
  EXPECT_FALSE(reply());
  kill(pid_, SIGTERM);
  EXPECT_EQ(exit_code(), kStopped);
}

}  // namespace
}  // namespace mrroc::process::end_request_test
