#pragma once

#include <memory>
#include <vector>

#include "clock/clock.hpp"
#include "links/transport/domain.hpp"
#include "links/transport/endpoint.hpp"
#include "links/transport/header.hpp"
#include "links/transport/writer.hpp"

namespace mrroc::links {

struct ReaderOptions {
  /// Messages kept between two calls; when more arrive the oldest are overwritten and counted.
  std::size_t depth = 16;
  bool counted = true;  ///< as the topic's writer
  /// Writers through which a received ping is answered; they must outlive the reader.
  std::vector<WriterBase*> answer_through = {};
};

/// Messages that a reader has dropped since its creation.
struct ReaderCounters {
  std::uint64_t malformed = 0;    ///< values out of range
  std::uint64_t stale = 0;        ///< overtaken by a newer message, or too old
  std::uint64_t overwritten = 0;  ///< not taken in time
};

/// A reader of a topic: a listener (Cyclone's receive thread) stores each message and notifies the clock; the
/// participant's thread takes them. Under simulated time a message becomes visible in the delta after its own. T as for
/// `Writer`. Construct before the clock starts; the domain and the clock outlive it. One thread calls the taking
/// functions: they neither wait, lock nor allocate, and when they return false their arguments are unchanged.
template <class T>
class Reader final : public ReaderBase {
 public:
  /// Throws SystemError: a bad topic name (configuration), an error of DDS (resources).
  Reader(Domain& domain, clock::Clock& clock, const std::string& topic, ReaderOptions options = {});
  ~Reader() override;

  /// The oldest message not yet taken.
  bool take(T& message, Header& header);
  /// The newest message; those before it are dropped as stale.
  bool take_newest(T& message, Header& header);
  /// As `take_newest`, but a message sent more than `max_age` s ago is stale too. For messages that may move a robot: a
  /// process that was stopped receives everything that has queued up. Stamps count from tick 0, which is common to all
  /// machines; under simulated time, and from another machine before tick 0, every message counts as fresh.
  bool take_fresh(T& message, Header& header, double max_age);
  /// Whether the message with this header was sent at most `max_age` s ago, as above.
  bool fresh(const Header& header, double max_age) const noexcept;
  /// The answer with the header's sequence, boot and answers; the messages before it are dropped as stale, undecoded.
  bool take_answer(T& message, const Header& expected);
  /// Sends the message that a function above returned last, as it came, through `writer` (`Writer::write`).
  void forward(Writer<T>& writer, std::uint64_t sequence, std::uint64_t answers = 0);
  /// The newest message so far; may be called repeatedly.
  bool latest(T& message);

  /// Whether a writer of the topic is alive. It is lost when it ends or its process is silent for the domain's lease;
  /// the clock is notified of every change. Any thread.
  bool peer_alive() const noexcept;
  ReaderCounters counters() const noexcept;

  const std::string& topic() const noexcept override;
  void expect_pong() noexcept override;
  std::uint64_t ponged() const noexcept override;
  std::string problem() const override;
  /// The DDS reader.
  std::int32_t entity() const noexcept;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace mrroc::links
