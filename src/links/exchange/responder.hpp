#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "clock/clock.hpp"
#include "links/transport/reader.hpp"
#include "links/transport/writer.hpp"

namespace mrroc::links {

template <class Request, class Reply>
class Requester;

/// The answering side of a link; it answers the requester's hand-shake automatically. The participant's thread calls
/// it. <Request, Reply> as for `Requester`.
template <class Request, class Reply>
class Responder {
 public:
  /// A request older than `max_age` s is dropped (`Reader::take_fresh`). Pings are answered through `also` as well.
  Responder(Domain& domain, clock::Clock& clock, const std::string& request_topic, const std::string& reply_topic,
            double max_age = std::numeric_limits<double>::infinity(), std::vector<WriterBase*> also = {});

  /// The newest request not yet taken, and its number for `reply`; false when there is none. Does not wait.
  bool take(Request& request, std::uint64_t& sequence);

  /// Whether the request taken last was sent at most `max_age` s ago (`Reader::take_fresh`).
  bool fresh(double max_age) const noexcept { return reader_.fresh(taken_, max_age); }

  /// Answers the request taken last. False when another request has overtaken it; it is then not answered.
  bool reply(const Reply& reply, std::uint64_t sequence);
  /// As `reply`, with the reply that `requester` has received last, as it came.
  bool forward(Requester<Request, Reply>& requester, std::uint64_t sequence);

  bool peer_alive() const noexcept { return reader_.peer_alive(); }
  ReaderCounters counters() const noexcept { return reader_.counters(); }

 private:
  friend class Requester<Request, Reply>;
  const double max_age_;
  Writer<Reply> writer_;
  Reader<Request> reader_;
  Header taken_;
};

}  // namespace mrroc::links
