#pragma once

#include <cstdint>
#include <string>

namespace mrroc::links {

/// What the hand-shake needs to know of a writer, whatever it writes. Any thread.
class WriterBase {
 public:
  virtual ~WriterBase() = default;
  virtual const std::string& topic() const noexcept = 0;
  /// Asks whoever reads the topic for a pong. Not counted by the clock, not seen by `take`.
  virtual void ping() noexcept = 0;
  /// Answers the ping of the process with this boot number.
  virtual void pong(std::uint64_t boot) noexcept = 0;
  /// Why a reader of this topic was refused, empty when none was.
  virtual std::string problem() const = 0;
};

/// The same of a reader. Any thread.
class ReaderBase {
 public:
  virtual ~ReaderBase() = default;
  virtual const std::string& topic() const noexcept = 0;
  /// Forgets an earlier answer to this process's pings.
  virtual void expect_pong() noexcept = 0;
  /// Boot number of the process that has answered this process's ping on this topic; 0: none yet.
  virtual std::uint64_t ponged() const noexcept = 0;
  /// Why a writer of this topic was refused, empty when none was.
  virtual std::string problem() const = 0;
};

}  // namespace mrroc::links
