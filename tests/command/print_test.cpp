#include "command/print.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdio>

#include "mrroc/errors.hpp"

namespace mrroc::command {
namespace {

/// Redirects the standard output to another file until the end of the scope.
class RedirectedOutput {
 public:
  explicit RedirectedOutput(const char* file) {
    std::fflush(stdout);
    const int fd = open(file, O_WRONLY | O_CLOEXEC);
    dup2(fd, STDOUT_FILENO);
    close(fd);
  }
  ~RedirectedOutput() {
    dup2(saved_, STDOUT_FILENO);
    close(saved_);
    std::fflush(stdout);
    std::clearerr(stdout);
  }
  RedirectedOutput(const RedirectedOutput&) = delete;
  RedirectedOutput& operator=(const RedirectedOutput&) = delete;

 private:
  int saved_ = fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, 3);
};

TEST(Print, FullDiskIsAnError) {
  const RedirectedOutput full("/dev/full");
  try {
    print("text\n");
    ADD_FAILURE() << "printed";
  } catch (const SystemError& error) {
    EXPECT_EQ(error.code(), ErrorCode::resources);
    EXPECT_NE(std::string{error.what()}.find("No space left on device"), std::string::npos) << error.what();
  }
}

TEST(Print, ChecksBufferedTextToo) {
  const RedirectedOutput full("/dev/full");
  std::printf("text");
  EXPECT_THROW(finish_output(), SystemError);
}

TEST(Print, SuccessfulOutputIsNoError) {
  const RedirectedOutput null("/dev/null");
  print("text\n");
  std::printf("text");
  finish_output();
}

}  // namespace
}  // namespace mrroc::command
