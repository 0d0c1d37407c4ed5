#pragma once

#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <optional>
#include <stdexcept>
#include <string>

namespace mrroc::test {

/// Replaces this process's standard input, which `mrroc` inherits, with another file.
class StandardInput {
 public:
  explicit StandardInput(int fd) : before_(fcntl(STDIN_FILENO, F_DUPFD_CLOEXEC, 3)) { dup2(fd, STDIN_FILENO); }
  ~StandardInput() {
    dup2(before_, STDIN_FILENO);
    close(before_);
  }
  StandardInput(const StandardInput&) = delete;
  StandardInput& operator=(const StandardInput&) = delete;

 private:
  int before_;
};

/// A pipe for the input of the test.
class Keyboard {
 public:
  Keyboard() {
    if (pipe2(ends_, O_CLOEXEC) != 0) throw std::runtime_error("no pipe");
    input_.emplace(ends_[0]);
  }
  ~Keyboard() {
    input_.reset();
    leave();
    close(ends_[0]);
  }
  void type(const std::string& line) { ASSERT_EQ(write(ends_[1], line.data(), line.size()), std::ssize(line)); }
  void leave() {
    if (ends_[1] >= 0) close(ends_[1]);
    ends_[1] = -1;
  }

 private:
  int ends_[2] = {-1, -1};
  std::optional<StandardInput> input_;
};

}  // namespace mrroc::test
