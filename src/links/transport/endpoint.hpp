#pragma once

#include <cstdint>
#include <string>

namespace mrroc::links {

/// The interface of a writer of any type for the hand-shake. Any thread.
class WriterBase {
 public:
  virtual ~WriterBase() = default;
  virtual const std::string& topic() const noexcept = 0;
  /// Requests a pong from the readers of the topic. Not counted by the clock, not returned by `take`.
  virtual void ping() noexcept = 0;
  /// Answers the ping of the process with this boot number.
  virtual void pong(std::uint64_t boot) noexcept = 0;
  /// The reason why a reader of this topic was refused; empty when none was.
  virtual std::string problem() const = 0;
};

/// The same of a reader. Any thread.
class ReaderBase {
 public:
  virtual ~ReaderBase() = default;
  virtual const std::string& topic() const noexcept = 0;
  /// Discards an earlier answer to this process's pings.
  virtual void expect_pong() noexcept = 0;
  /// Boot number of the process that has answered this process's ping on this topic; 0: none yet.
  virtual std::uint64_t ponged() const noexcept = 0;
  /// The reason why a writer of this topic was refused; empty when none was.
  virtual std::string problem() const = 0;
};

}  // namespace mrroc::links
