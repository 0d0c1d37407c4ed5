#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "clock/clock.hpp"
#include "links/transport/reader.hpp"
#include "links/transport/writer.hpp"

namespace mrroc::links {

template <class Request, class Reply>
class Responder;

/// The asking side of a link: one request, then its reply. At most one exchange is under way; the participant's thread
/// calls it. <Request, Reply> is <RobotCommand, RobotState> or <SensorRequest, SensorReading>.
template <class Request, class Reply>
class Requester {
 public:
  /// `peer`: name of the other side in errors.
  Requester(Domain& domain, clock::Clock& clock, const std::string& request_topic, const std::string& reply_topic,
            std::string peer);

  /// Hand-shake, see `connect`; also on `also`, readers of the responder's other topics. Before the clock starts.
  void connect(double timeout, std::vector<ReaderBase*> also = {});

  /// Sends a request; does not wait. Its reply is due at `deadline`.
  void send(const Request& request, Tick deadline);

  /// As `send`, of the request that `responder` has taken last, as it came.
  void forward(Responder<Request, Reply>& responder, Tick deadline);

  /// Waits on the clock for the reply to the last `send`. Every other message is dropped and counted: a reply to
  /// another request, to another process, or from before the peer's restart. Throws SystemError: process_died
  /// (link_lost when other machines take part) when the peer is lost (in simulated time the clock's host detects that),
  /// process_silent when the deadline has passed. Throws Stopped when the clock is interrupted.
  void receive(Reply& reply);
  /// As `receive`, but does not wait: false when the reply has not arrived yet.
  bool poll(Reply& reply);

  bool peer_alive() const noexcept { return reader_.peer_alive(); }
  std::uint64_t stale_replies() const noexcept { return reader_.counters().stale; }
  /// Received messages that were refused.
  std::uint64_t malformed_replies() const noexcept { return reader_.counters().malformed; }

 private:
  friend class Responder<Request, Reply>;
  bool take_reply(Reply& reply);
  [[noreturn]] void throw_lost() const;

  clock::Clock& clock_;
  const std::string peer_;
  const std::uint64_t boot_;
  const bool loopback_only_;
  Writer<Request> writer_;
  Reader<Reply> reader_;
  std::uint64_t sequence_ = 0;  // of the last request
  Tick deadline_ = kNever;
};

}  // namespace mrroc::links
