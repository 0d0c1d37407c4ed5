#pragma once

#include <string>

namespace mrroc::process {

/// A text in anonymous, sealed memory (memfd) that processes inherit: the same for all of them, independent of later
/// changes of the source file. Any thread.
class TextMemory {
 public:
  /// Throws SystemError(resources) with the reason when there is no memory.
  explicit TextMemory(const std::string& text);
  ~TextMemory();
  TextMemory(const TextMemory&) = delete;
  TextMemory& operator=(const TextMemory&) = delete;

  int fd() const noexcept { return fd_; }

 private:
  int fd_;
};

/// The whole text of such a descriptor, or of a regular file. Throws SystemError(resources) when it cannot be read.
std::string read_text(int fd);

}  // namespace mrroc::process
