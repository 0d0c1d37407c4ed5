#include "cli/operator/terminal/terminal_mode.hpp"

#include <unistd.h>

namespace mrroc::cli {

TerminalMode::TerminalMode(int fd) noexcept : fd_(fd) {
  if (isatty(fd) == 0 || tcgetpgrp(fd) != getpgrp() || tcgetattr(fd, &before_) != 0) return;
  termios keys = before_;
  keys.c_lflag &= ~static_cast<tcflag_t>(ICANON | ECHO);
  keys.c_cc[VMIN] = 1;
  keys.c_cc[VTIME] = 0;
  active_ = tcsetattr(fd, TCSANOW, &keys) == 0;
}

TerminalMode::~TerminalMode() {
  // from the background this would stop the process
  if (active_ && tcgetpgrp(fd_) == getpgrp()) tcsetattr(fd_, TCSANOW, &before_);
}

}  // namespace mrroc::cli
