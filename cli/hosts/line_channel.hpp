#pragma once

#include <string>
#include <vector>

namespace mrroc::cli {

/// Lines to and from another process. It never waits for the peer: a peer that does not read must not hold a process
/// that has robots to stop. One thread.
class LineChannel {
 public:
  /// Takes both descriptors, which may be the same, and closes them in the destructor.
  LineChannel(int in, int out);
  ~LineChannel();
  LineChannel(const LineChannel&) = delete;
  LineChannel& operator=(const LineChannel&) = delete;

  /// The whole lines that have arrived.
  std::vector<std::string> read();
  /// True when the peer has closed its end, or is gone.
  bool closed() const noexcept { return closed_; }
  /// Sends a line; the next `write` or `flush` retries the text that the peer did not take.
  void write(const std::string& line);
  void flush();
  /// Bytes that the peer has not taken yet.
  std::size_t waiting() const noexcept { return outgoing_.size() - sent_; }
  /// Closes the sending side; reading continues.
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
