#pragma once

#include <string>
#include <vector>

namespace mrroc::cli {

/// Lines to and from another process, never waiting for it: a peer that does not read must not hold who has robots to
/// stop. One thread.
class LineChannel {
 public:
  /// Takes both descriptors, which may be one, and closes them at its end.
  LineChannel(int in, int out);
  ~LineChannel();
  LineChannel(const LineChannel&) = delete;
  LineChannel& operator=(const LineChannel&) = delete;

  /// Whole lines that have come.
  std::vector<std::string> read();
  /// The peer has closed its end, or is gone.
  bool closed() const noexcept { return closed_; }
  /// Sends a line; what the peer does not take is kept and tried again by the next `write` or `flush`.
  void write(const std::string& line);
  void flush();
  /// How much waits to be taken, bytes.
  std::size_t waiting() const noexcept { return outgoing_.size() - sent_; }
  /// Says the peer that no more comes; reading continues.
  void finish() noexcept;

  int fd() const noexcept { return in_; }

 private:
  int in_;
  int out_;
  bool closed_ = false;
  std::string incoming_;
  std::string outgoing_;
  std::size_t sent_ = 0;  // of `outgoing_`
};

}  // namespace mrroc::cli
